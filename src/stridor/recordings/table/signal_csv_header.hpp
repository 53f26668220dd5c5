#pragma once

// The lines above the numbers of a table of signals.

#include "stridor/base/error.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::recordings::signal_table {

inline constexpr double highest_rate = 1e12;  // [Hz] of the fastest oscilloscopes

/// The content of a column.
enum class Role { channel, time, other_time, counter, words, empty, damaged };

/// One column of the table.
struct SignalColumn {
    std::string name;
    std::string unit;  // as the file has it
    Role role = Role::channel;
    std::string why{};  // the reason why it is no channel
};

/// The heading that LabVIEW repeats before each part of a table.
struct PartHeading {
    std::string names{};  // the line of the names; empty: no such table
    std::string steps{};  // the line Delta_X
};

/// The line that ends each of LabVIEW's headings.
inline constexpr std::string_view heading_end = "***End_of_Header***";

/// The facts above the numbers.
struct TableHeader {
    csv_table::Dialect dialect;
    std::vector<SignalColumn> columns;
    std::vector<std::pair<std::string, std::string>> metadata;
    std::optional<double> rate;             // [Hz] from a `# rate:` line
    std::optional<double> spoken_rate;      // [Hz] from the prose above the table
    std::vector<std::string> spoken_units;  // of the columns, from the prose above the table
    std::vector<double> spoken_steps;       // of the columns, from the prose above the table; 0: none
    PartHeading heading{};
    std::size_t prose_lines = 0;  // [1] of text above the table
    bool has_names = false;
    bool has_comment = false;       // a row may have a remark behind its columns
    std::uint64_t data_offset = 0;  // [bytes] of the first row of numbers
    int data_number = 1;            // [1] its line
    int names_number = 0;           // [1] the line of the names; 0: none
    int end_number = 0;             // [1] the line of the first text behind the table; 0: none
};

/// Says whether a line is neither blank nor a comment.
bool is_table_line(std::string_view line);

/// Returns the next line of the table, or `std::nullopt` at its end; its text is valid until the next is read.
std::optional<TextLine> next_row(LineReader& lines);

/// Reads up to the first row of numbers. Throws `Error` (input) with line and column for a text that is not a table of
/// signals, such as the tables that Stridor writes of a chart.
TableHeader read_header(const SignalInput& input);

}  // namespace stridor::recordings::signal_table
