#pragma once

// What all CSV texts share.
//
// Line 1 begins with # and says what the table is: "# schema: stridor.trace/1 | version: 0.1.0 | ...".
// Line 2 holds the names with their units: "gap [m]". The numbers begin in line 3 of every table. So one plain call
// reads any of them: pandas and R skip a line that begins with #, Octave's dlmread and spreadsheets skip two lines. No
// row of units is taken for data.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::base::csv_text {

/// Separates the facts of the first line.
inline constexpr std::string_view fact_mark = " | ";

/// One statement of a table about itself: "contact.preload", "20 N".
using Fact = std::pair<std::string, std::string>;
using Facts = std::vector<Fact>;

/// The heading of a column.
struct TableColumn {
    std::string name;
    std::string unit{};  // empty or "1": words, or a number without dimension
};

/// Returns the facts that every result begins with: schema "stridor.WHAT/1", version, commit.
Facts origin(std::string_view what);

/// Returns the first line of a table with all facts. A fact must not hold a line end, the mark or a quote, nor look
/// like a formula.
std::string first_line(const Facts& facts);

/// Returns a text as a field after RFC 4180. A # is quoted too, so that it does not begin a comment; a text never reads
/// as a formula.
std::string quoted(std::string_view words);

/// A table as text: the first line, the names, then rows of fields.
class Table {
public:
    /// Writes the first line from the facts, then the line of headings.
    Table(const Facts& facts, const std::vector<TableColumn>& columns);

    /// Adds a field of words, quoted where it must be.
    void word(std::string_view word) { field(quoted(word)); }
    /// Adds a number; NaN becomes an empty field.
    void number(double value);
    /// Ends the row; the next field begins another one.
    void end_row();

    /// Returns the text written since the last call.
    std::string take() { return std::exchange(text_, {}); }

private:
    void field(std::string_view text);

    std::string text_;
    bool is_first_ = true;
};

}  // namespace stridor::base::csv_text
