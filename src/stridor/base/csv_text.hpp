#pragma once

// What all CSV texts share. Private to this folder.
//
// Line 1 begins with # and says what the table is, all in one line: "# schema: stridor.trace/1 | version: 0.1.0 | ...".
// Line 2 holds the names, with their units: "gap [m]". Numbers begin in line 3, whatever the table. So one plain line
// reads any of them: pandas and R skip what begins with #, Octave's dlmread and spreadsheets a known number of lines;
// no row of units is taken for data.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::base::csv_text {

/// What parts the facts of the first line.
inline constexpr std::string_view fact_mark = " | ";

/// One thing that a table says of itself: "contact.preload", "20 N".
using Fact = std::pair<std::string, std::string>;
using Facts = std::vector<Fact>;

/// The heading of a column.
struct TableColumn {
    std::string name;
    std::string unit{};  // empty or "1": words, or a number without dimension
};

/// The facts of a whole result: schema "stridor.WHAT/1", version, commit.
Facts origin(std::string_view what);

/// The first line of a table: all of them. No fact may end the line, hold the mark or a quote, or look like a formula.
std::string first_line(const Facts& facts);

/// A text as a field, after RFC 4180; a # is quoted too, so that it is not taken for a comment, and no text is taken
/// for a formula.
std::string quoted(std::string_view words);

/// Rows of fields behind the first line and the names.
class Table {
public:
    /// Begins with the first line, of facts, and the headings.
    Table(const Facts& facts, const std::vector<TableColumn>& columns);

    /// Adds a field of words, quoted where it must be.
    void word(std::string_view word) { field(quoted(word)); }
    /// NaN is an empty field.
    void number(double value);
    /// Ends the row; the next field begins another one.
    void end_row();

    /// What was written since it was taken last.
    std::string take() { return std::exchange(text_, {}); }

private:
    void field(std::string_view text);

    std::string text_;
    bool is_first_ = true;
};

}  // namespace stridor::base::csv_text
