#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The rows of a measured curve as text, "0: 0.8, 10 mm/s: 0.6": friction over speed, force over deflection.
namespace stridor::parameters {

/// Rows of a curve, shape [row], or the name of the file that has them.
struct CurveRows {
    std::string file{};  // a CSV, not opened here; empty: the rows are these
    std::vector<double> places{};
    std::vector<double> values{};
};

/// How a table is called, and what stands in a row of it.
struct CurveWords {
    std::string_view table;       // "table of friction"
    std::string_view row;         // "a speed, a colon and a coefficient"
    std::string_view example;     // "10 mm/s: 0.6"
    std::string_view place_unit;  // "m/s"
    std::string_view value_unit;  // "1"
};

/// The rows of a curve, at most.
inline constexpr std::size_t most_curve_rows = 10000;

/// Returns "0: 0.8, 0.01: 0.6".
std::string rows_text(const std::vector<double>& places, const std::vector<double>& values);

/// Reads rows as text; one without a colon is the name of a file. Throws `Error` (input) without a place for what is
/// none.
CurveRows parse_rows(std::string_view text, const CurveWords& words);

/// Throws `Error` (input) without a place: row number `row`, from 1, is wrong.
[[noreturn]] void refuse_row(std::size_t row, const CurveWords& words, const std::string& what, const std::string& why,
                             const std::string& remedy);

/// Throws `Error` (input) without a place for fewer than two rows, and for too many. `instead`: what to use.
void expect_some_rows(std::size_t rows, const CurveWords& words, std::string_view instead);

}  // namespace stridor::parameters
