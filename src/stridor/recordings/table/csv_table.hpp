#pragma once

// What all readers of CSV share.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings::csv_table {

/// The mark that some programs put before UTF-8.
inline constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// What a table is written in.
struct Dialect {
    char delimiter = ',';  // 0: a single column
    /// May a comma be the decimal mark?
    bool allows_comma() const { return delimiter != ','; }
};

/// One field of a row.
struct CsvField {
    std::string text;
    int column = 1;  // [1] of its first character
};

/// Tab, semicolon or comma, whichever the line holds in this order, what is quoted left out; comma where it has none.
Dialect sniff(std::string_view line);

/// The fields of a row without their quotes and surrounding blanks.
std::vector<CsvField> split(std::string_view line, char delimiter);

/// Drops empty fields behind the `least` first: a delimiter at the end of every line is a habit of some programs.
void drop_empty_tail(std::vector<CsvField>& fields, std::size_t least);

/// The text of a number with a decimal point.
std::string numeral(std::string text, Dialect dialect);

/// The number that a field is; infinite beyond double precision, nothing for any other text.
std::optional<double> number_in(const std::string& field, Dialect dialect);

/// Does any field hold a number?
bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect);

/// "velocity [mm/s]" or "velocity (mm/s)" taken apart; "gap (front) [m]" is "gap (front)" in m.
struct Title {
    std::string name;
    std::string unit;  // empty: none
};

/// Takes a title apart. It never fails: what has no brackets is all name.
Title title_of(std::string_view text);

/// A unit of the row of units: "[ms]" and "(ms)" are "ms".
std::string_view bare_unit(std::string_view text);

/// ASCII letters made small.
std::string lower(std::string_view text);

/// Does the text begin with the mark of UTF-16?
bool is_utf16(std::string_view text);

}  // namespace stridor::recordings::csv_table
