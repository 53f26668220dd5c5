#pragma once

#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>

/// A table of friction over the speed of slip as text: what a case file, `--set` and a stored case say of it.
namespace stridor::parameters {

/// Returns "0: 0.8, 0.01: 0.6", the speed [m/s] and coefficient of each row; the name of its file where that is not
/// read yet.
std::string friction_table_text(const FrictionTable& table);

/// Reads rows as text: "0: 0.8, 10 mm/s: 0.6". A text without a colon is the name of a CSV file, not opened here.
/// Throws `Error` (input) without a place for rows that make no function: falling speeds, one row, negative numbers.
FrictionTable parse_friction_table(std::string_view text);

/// Throws `Error` (input) without a place for rows that make no function.
void expect_function(const FrictionTable& table);

}  // namespace stridor::parameters
