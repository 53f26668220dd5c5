#pragma once

// The rows of a table of signals, and a survey of its columns. Private to this folder.

#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stridor::recordings::signal_table {

/// Rows of a table as numbers.
class TableRows {
public:
    TableRows(const SignalInput& input, const TableHeader& header);

    /// Returns the numbers of the next row, shape [column]: NaN if a field is empty, a word, or an instrument's mark
    /// for an overload. Empty at the end of the table. Throws `Error` (input) for a row of another width.
    std::span<const double> next();

    /// Returns the fields of the row that was read last.
    std::vector<csv_table::CsvField> fields() const;

    /// Returns the place of a column in that row.
    base::Place place(std::size_t column) const;

    /// Says whether the row that was read last is text, as it stands behind a table.
    bool is_text() const { return is_text_; }
    /// Returns the number of its line.
    int number() const { return line_->number; }

    /// Counts of special cases so far.
    struct Met {
        std::size_t comments = 0;  // [1] rows with a remark behind their columns
        std::size_t grouped = 0;   // [1] numbers whose only mark parts thousands
        std::size_t headings = 0;  // [1] between the rows, as LabVIEW repeats its own
    };
    const Met& met() const { return met_; }

private:
    bool read_plain();
    void read_fields();
    void skip_heading();

    csv_table::Dialect dialect_;
    bool has_comment_;
    PartHeading heading_;
    int end_;  // [1] line of the text behind the table; 0: none
    LineReader lines_;
    std::optional<TextLine> line_{};
    std::vector<double> values_;
    int last_number_;  // [1] of the row before
    bool is_text_ = false;
    Met met_{};
};

/// A survey of one column.
struct ColumnSurvey {
    std::uint64_t numbers = 0;                // [1] rows that have one
    std::uint64_t empty = 0;                  // [1] rows that have none
    std::map<double, std::uint64_t> marks{};  // [1] rows with each number that may stand for no value: -9999
    double largest = 0.0;                     // [unit] magnitude, these aside
    bool is_rising = true;                    // every number is greater than the one before
    bool is_even = true;                      // it changes by the same step in every row, about
    bool is_whole = true;                     // every number is a whole one
    std::uint64_t rests = 0;                  // [1] steps of 0
    std::uint64_t ups = 0;                    // [1] steps of 1
    std::uint64_t downs = 0;                  // [1] steps of -1
    double first = 0.0;
    double second = 0.0;
    double last = 0.0;
    std::optional<base::Place> trouble{};  // of the first field that is not a number
    std::string trouble_text{};            // that field
};

/// A survey of a table.
struct TableSurvey {
    std::uint64_t rows = 0;
    std::vector<ColumnSurvey> columns{};
    int end = 0;              // [1] line of the first text behind the table; 0: none
    std::string text_behind;  // that line
    TableRows::Met met{};

    /// Says whether a column has a number in every row.
    bool is_whole(std::size_t column) const { return columns[column].numbers == rows; }
};

/// Reads every row of a table. Throws `Error` (input) with its place for a row of another width, and for text between
/// rows of numbers.
TableSurvey surveyed(const SignalInput& input, const TableHeader& header);

}  // namespace stridor::recordings::signal_table
