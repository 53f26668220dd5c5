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

/// What a table is written in.
struct Dialect {
    char delimiter = ',';              // 0: a single column; a blank: any number of blanks and tabs
    bool has_quoted_decimals = false;  // "0,5" in quotes between commas is 0.5, and no thousands
    char grouping = '\0';              // parts thousands, as the other mark is seen to be the decimal one; 0: not known
    /// May a comma be the decimal mark?
    bool allows_comma() const { return delimiter != ',' || has_quoted_decimals; }
};

/// One field of a row.
struct CsvField {
    std::string text;
    int column = 1;  // [1] of its first character
};

/// Tab, semicolon or comma, whichever the line holds in this order, what is quoted left out; comma where it has none.
Dialect sniff(std::string_view line);

/// The fields of a row without their quotes and surrounding blanks. Where blanks part the fields, a unit in brackets
/// belongs to what stands before it.
std::vector<CsvField> split(std::string_view line, char delimiter);

/// The names in a line above `width` columns: parted by blanks, they may hold blanks themselves if two part them.
std::vector<CsvField> split_names(std::string_view line, char delimiter, std::size_t width);

/// Drops empty fields behind the `least` first: a delimiter at the end of every line is a habit of some programs.
void drop_empty_tail(std::vector<CsvField>& fields, std::size_t least);

/// How many fields there are up to the last that is not empty.
std::size_t filled(const std::vector<CsvField>& fields);

/// Does this field tell that `mark` is the decimal one? "0,5" and "12,25" do, "1,234" may be thousands.
bool tells_decimal(const CsvField& field, char mark);

/// May this number be meant in thousands: "1.500", "12,345"?
bool tells_grouping(const std::string& text);

/// The text of a number with a decimal point, and without what parts thousands; empty where their marks are misplaced.
std::string numeral(std::string text, Dialect dialect);

/// The number that a field is; infinite beyond double precision, nothing for any other text.
std::optional<double> number_in(const std::string& field, Dialect dialect);

/// Reads a number, and what `instant_in` reads, in seconds.
std::optional<double> value_in(const std::string& field, Dialect dialect);

/// Does any field hold a number?
bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect);

/// "velocity [mm/s]", "velocity (mm/s)", "velocity / mm/s", "v/(mm/s)", "velocity in mm/s" or "velocity, mm/s" taken
/// apart; "gap (front) [m]" is "gap (front)" in m.
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

/// How a text in UTF-16 is written.
struct Utf16 {
    std::size_t begin = 0;  // [bytes] of its mark
    std::size_t high = 0;   // which byte of a pair is the high one
};

/// Is it a text in UTF-16, with its mark or without? Told from its first bytes.
std::optional<Utf16> utf16_in(std::string_view beginning);

/// A text in UTF-16 as UTF-8; what is no character becomes a question mark.
std::string utf8_of(std::string_view utf16, Utf16 form);

}  // namespace stridor::recordings::csv_table
