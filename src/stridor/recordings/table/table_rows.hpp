#pragma once

// The rows of a table of signals, and what is in its columns from the first to the last. Private to this folder.

#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stridor::recordings::signal_table {

/// Rows of a table as numbers.
class TableRows {
public:
    TableRows(const SignalInput& input, const TableHeader& header);

    /// The numbers of the next row, shape [column]: NaN where a field is empty, a word, or what instruments write for
    /// an overload. Empty at the end of the table. Throws `Error` (input) for a row of another width.
    std::span<const double> next();

    /// The fields of the row that was read last.
    std::vector<csv_table::CsvField> fields() const;

    /// Where a column of that row stands.
    base::Place place(std::size_t column) const;

    /// Is the row that was read last text, as it stands behind a table?
    bool is_text() const { return is_text_; }
    /// The number of its line.
    int number() const { return line_->number; }

private:
    bool read_plain();
    void read_fields();

    csv_table::Dialect dialect_;
    int end_;  // [1] line of the text behind the table; 0: none
    LineReader lines_;
    std::optional<TextLine> line_{};
    std::vector<double> values_;
    int last_number_;  // [1] of the row before
    bool is_text_ = false;
};

/// What is in a column.
struct ColumnSurvey {
    std::uint64_t numbers = 0;  // [1] rows that have one
    std::uint64_t empty = 0;    // [1] rows that have nothing
    std::uint64_t marks = 0;    // [1] rows with the mark below
    double mark = 0.0;          // a number that instruments write where they have none: -9999
    double largest = 0.0;       // [unit] magnitude, marks aside
    bool is_rising = true;      // every number is greater than the one before
    bool is_even = true;        // it changes by the same step in every row, about
    double first = 0.0;
    double second = 0.0;
    double last = 0.0;
    std::optional<base::Place> trouble{};  // of the first field that is no number
    std::string trouble_text{};            // that field
};

/// What is in a table.
struct TableSurvey {
    std::uint64_t rows = 0;
    std::vector<ColumnSurvey> columns{};
    int end = 0;              // [1] line of the first text behind the table; 0: none
    std::string text_behind;  // that line

    /// Has a column a number in every row?
    bool is_whole(std::size_t column) const { return columns[column].numbers == rows; }
};

/// Looks at every row of a table. Throws `Error` (input) with its place for a row of another width, and for text
/// between rows of numbers.
TableSurvey surveyed(const SignalInput& input, const TableHeader& header);

}  // namespace stridor::recordings::signal_table
