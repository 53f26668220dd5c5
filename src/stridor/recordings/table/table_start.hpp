#pragma once

// Finds where in a text the table begins: measuring programs write lines of prose above the names. Private to this
// folder.

#include "stridor/recordings/table/csv_table.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings::csv_table {

/// The lines of a text by their kind; `rows` is the first of numbers.
struct TableStart {
    Dialect dialect{};
    std::optional<std::size_t> names{};
    std::optional<std::size_t> units{};
    std::size_t rows = 0;
    std::size_t width = 0;     // [1] columns
    bool has_comment = false;  // some rows have one field more, a remark: LabVIEW's last column

    /// Returns the first line of the table; the lines above it are prose.
    std::size_t first() const { return names.value_or(rows); }
};

/// Finds the table in the first lines of a text, comments and blank lines left out.
///
/// The rows of numbers are the lines that reach to the last given one (or to a short text behind them), begin with a
/// number, hold more numbers than words, and have equal numbers of fields, apart from empty ones at their ends. The
/// names are the line above them with as many fields, or the one above that if the line between holds units. All lines
/// higher up are prose. The rows show which mark is the decimal one. Returns `std::nullopt` if there is no table.
std::optional<TableStart> find_start(std::span<const std::string> lines);

/// Removes the last of the names of a table `width` columns wide, if it is "Comment" and one too many: LabVIEW names a
/// column that no row has.
void drop_comment(std::vector<CsvField>& names, std::size_t width);

/// Says whether it is a usual name of a column of times.
bool is_time_name(std::string_view name);

}  // namespace stridor::recordings::csv_table
