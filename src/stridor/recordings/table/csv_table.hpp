#pragma once

// What all readers of CSV share.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings::csv_table {

/// The mark that some programs put before UTF-8.
inline constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// The decimal digits.
inline constexpr std::string_view all_digits = "0123456789";

/// The characters of a table.
struct Dialect {
    char delimiter = ',';              // 0: a single column; a blank: any number of blanks and tabs
    bool has_quoted_decimals = false;  // "0,5" in quotes between commas is 0.5, and no thousands
    char grouping = '\0';              // separates thousands, since another mark is the decimal one; 0: not known
    /// Says whether a comma may be the decimal mark.
    bool allows_comma() const { return delimiter != ',' || has_quoted_decimals; }
};

/// One field of a row.
struct CsvField {
    std::string text;
    int column = 1;  // [1] of its first character
};

/// Returns tab, semicolon or comma, whichever the line holds in this order outside of quotes; comma if it has none.
Dialect sniff(std::string_view line);

/// Returns the fields of a row without their quotes and surrounding blanks. If blanks separate the fields, a unit in
/// brackets belongs to the word before it.
std::vector<CsvField> split(std::string_view line, char delimiter);

/// Returns the names in a line above `width` columns. If blanks separate them, two blanks do, and a name may hold one.
std::vector<CsvField> split_names(std::string_view line, char delimiter, std::size_t width);

/// Drops empty fields behind the `least` first: a delimiter at the end of every line is a habit of some programs.
void drop_empty_tail(std::vector<CsvField>& fields, std::size_t least);

/// Returns the number of fields up to the last that is not empty.
std::size_t filled(const std::vector<CsvField>& fields);

/// Says whether this field shows that `mark` is the decimal one. "0,5" and "12,25" do; "1,234" may be thousands.
bool tells_decimal(const CsvField& field, char mark);

/// Says whether this number may be meant in thousands: "1.500", "12,345".
bool tells_grouping(const std::string& text);

/// Returns the text of a number with a decimal point and without separators of thousands; empty if the marks are
/// misplaced.
std::string numeral(std::string text, Dialect dialect);

/// Returns the number in a field; infinite beyond double precision, `std::nullopt` for any other text.
std::optional<double> number_in(const std::string& field, Dialect dialect);

/// Returns the number in a field, or the time that `instant_in` reads [s]; `std::nullopt` for any other text.
std::optional<double> value_in(const std::string& field, Dialect dialect);

/// Says whether any field holds a number.
bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect);

/// A title split into name and unit: "velocity [mm/s]", "velocity (mm/s)", "velocity / mm/s", "v/(mm/s)", "velocity in
/// mm/s" or "velocity, mm/s"; "gap (front) [m]" is "gap (front)" in m.
struct Title {
    std::string name;
    std::string unit;  // empty: none
};

/// Splits a title. It never fails: a title without brackets is all name.
Title title_of(std::string_view text);

/// Returns a unit from the row of units: "[ms]" and "(ms)" are "ms".
std::string_view bare_unit(std::string_view text);

/// Returns the text with ASCII letters in lower case.
std::string lower(std::string_view text);

/// The form of a text in UTF-16.
struct Utf16 {
    std::size_t begin = 0;  // [bytes] of its mark
    std::size_t high = 0;   // which byte of a pair is the high one
};

/// Returns the form of a text in UTF-16, with its mark or without, or `std::nullopt`. The first bytes decide.
std::optional<Utf16> utf16_in(std::string_view beginning);

/// Returns a text in UTF-16 as UTF-8; an invalid character becomes a question mark.
std::string utf8_of(std::string_view utf16, Utf16 form);

}  // namespace stridor::recordings::csv_table
