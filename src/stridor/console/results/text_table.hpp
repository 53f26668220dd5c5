#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/console/terminal.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the texts of all results share: columns, their headings, how they are aligned, and the dash of what is unknown.
namespace stridor::console {

/// One column of a table.
struct TextColumn {
    std::string heading;
    std::size_t width =
        0;  // [1] letters; a longer cell pushes what follows. 0: as wide as the widest, two blanks apart
    enum class Side : std::uint8_t { left, right } side = Side::right;
};

/// Returns a column whose cells begin below each other.
TextColumn left(std::string_view heading, std::size_t width = 0);

/// Returns a column whose cells end below each other, as numbers do.
TextColumn right(std::string_view heading, std::size_t width = 0);

/// Cells in columns. Without any heading it has no first line.
struct TextTable {
    std::vector<TextColumn> columns;
    std::string_view indent{};  // before each line
    Style heading = Style::plain;
    std::vector<std::vector<std::string>> rows{};  // a row may end before the last column
};

/// Adds a row of texts and numbers, each as `{}` writes it.
template <typename... Cells>
void add_row(TextTable& table, const Cells&... cells) {
    table.rows.push_back({fmt::format("{}", cells)...});
}

/// Returns the table as lines, without blanks at their ends.
std::string text_of(const TextTable& table);

/// Returns how many columns of a terminal a text takes [1]: Chinese letters take two, the codes of `styled` none.
std::size_t width_of(std::string_view text);

/// Returns a number by a format such as "{:.1f} %"; "-" where it is not finite.
std::string number_or_dash(double value, const char* format);

/// Returns " N", " 1/s"; nothing for a number without a dimension.
std::string after_number(std::string_view unit);

/// Returns "1 record", "2 records".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Returns a line for each figure that is held against a threshold, with the figure's error where it has one. The
/// widths are those of the two names.
std::string margin_lines(std::span<const classification::Margin> margins, std::size_t figure, std::size_t threshold);

}  // namespace stridor::console
