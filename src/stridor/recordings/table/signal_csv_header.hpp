#pragma once

// What stands above the numbers of a table of signals. Private to this folder.

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

inline constexpr double highest_rate = 1e9;  // [Hz]

/// What a column holds.
enum class Role { channel, time, words };

/// One column of the table.
struct SignalColumn {
    std::string name;
    std::string unit;  // as the file has it
    Role role = Role::channel;
};

/// What stands above the numbers.
struct TableHeader {
    csv_table::Dialect dialect;
    std::vector<SignalColumn> columns;
    std::vector<std::pair<std::string, std::string>> metadata;
    std::optional<double> rate;         // [Hz] from a `# rate:` line
    std::optional<double> spoken_rate;  // [Hz] from the prose above the table; its times know better
    std::size_t prose_lines = 0;        // [1] of text above the table
    bool has_names = false;
    std::uint64_t data_offset = 0;  // [bytes] of the first row of numbers
    int data_number = 1;            // [1] its line
};

/// Is a line neither blank nor a comment?
bool is_table_line(std::string_view line);

/// The next line of the table; its text lasts until the next is read.
std::optional<TextLine> next_row(LineReader& lines);

/// Reads up to the first row of numbers. Throws `Error` (input) with line and column for what is no table of signals,
/// as the tables that Stridor writes of a chart.
TableHeader read_header(const SignalInput& input);

/// Leaves out columns in which the first row has no number; returns what to tell the user.
std::vector<std::string> find_words(TableHeader& header, const SignalInput& input);

/// The column of times: one that is called so, or the first of a table without names whose rate is not known.
std::optional<std::size_t> find_time(const TableHeader& header, bool is_rate_known);

}  // namespace stridor::recordings::signal_table
