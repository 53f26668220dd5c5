#pragma once

// Where in a text the table begins: measuring programs write lines of prose above the names. Private to this folder.

#include "stridor/recordings/table/csv_table.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings::csv_table {

/// Which lines of a text are what; `rows` is the first of numbers.
struct TableStart {
    Dialect dialect{};
    std::optional<std::size_t> names{};
    std::optional<std::size_t> units{};
    std::size_t rows = 0;
    std::size_t width = 0;     // [1] columns
    bool has_comment = false;  // some rows have one field more, a remark: LabVIEW's last column

    /// The first line of the table; what stands above it is prose.
    std::size_t first() const { return names.value_or(rows); }
};

/// Finds the table in the first lines of a text, comments and blank lines left out.
///
/// The rows of numbers are the lines that reach to the last one given (or to what little text is behind them), begin
/// with a number, hold more numbers than words, and have as many fields as each other, empty ones at their ends aside.
/// The names are the line above them that has as many fields, or the one above that, if the one between holds units.
/// What is higher up is prose. Which mark is the decimal one is seen in the rows. Nothing where this finds no table.
std::optional<TableStart> find_start(std::span<const std::string> lines);

/// Drops the last of the names of a table `width` columns wide, if it is "Comment" and one too many: LabVIEW names a
/// column that no row has.
void drop_comment(std::vector<CsvField>& names, std::size_t width);

/// Is it what a column of times is called?
bool is_time_name(std::string_view name);

}  // namespace stridor::recordings::csv_table
