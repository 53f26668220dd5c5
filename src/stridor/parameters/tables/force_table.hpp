#pragma once

#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>

/// A table of force over deflection as text: what a case file, `--set` and a stored case say of it.
namespace stridor::parameters {

/// Returns "0: 0, 0.001: 2", the deflection [m] and force [N] of each row; the name of its file where that is not read
/// yet.
std::string force_table_text(const ForceTable& table);

/// Reads rows as text: "0: 0, 1 mm: 2 N". A text without a colon is the name of a CSV file, not opened here. Throws
/// `Error` (input) without a place for rows that are no function, and for forces that fall.
ForceTable parse_force_table(std::string_view text);

/// Throws `Error` (input) without a place for rows that are no function, and for forces that fall.
void expect_rising(const ForceTable& table);

}  // namespace stridor::parameters
