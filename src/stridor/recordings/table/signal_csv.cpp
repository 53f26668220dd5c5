#include "stridor/recordings/table/signal_csv.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/refusal.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/time_grid.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace stridor::recordings {

namespace {

using csv_table::CsvField;
using signal_table::highest_rate;
using signal_table::is_table_line;
using signal_table::next_row;
using signal_table::Role;
using signal_table::SignalColumn;
using signal_table::TableHeader;

constexpr std::size_t looked_at = 1024;  // rows that the rate is first taken from

/// Rows of a table as numbers.
class Rows {
public:
    Rows(const SignalInput& input, TableHeader header)
        : header_(std::move(header)),
          lines_(input.bytes, input.name, header_.data_offset, header_.data_number),
          values_(header_.columns.size()) {
        has_words_ = std::any_of(header_.columns.begin(), header_.columns.end(),
                                 [](const SignalColumn& column) { return column.role == Role::words; });
    }

    /// The numbers of the next row, shape [column], NaN in columns of words; empty at the end.
    std::span<const double> next() {
        line_ = next_row(lines_);
        if (!line_) return {};
        if (has_words_ || !read_plain()) read_fields();
        return values_;
    }

    /// The fields of the row that was read last.
    std::vector<CsvField> fields() const {
        std::vector<CsvField> fields = csv_table::split(line_->text, header_.dialect.delimiter);
        csv_table::drop_empty_tail(fields, header_.columns.size());
        return fields;
    }

    base::Place place(std::size_t column) const { return place_of(lines_.name(), *line_, fields()[column].column); }

private:
    // the usual row, without words, quotes and decimal commas; false for any other
    bool read_plain() {
        const char* at = line_->text.data();
        const char* const end = at + line_->text.size();
        const auto skip = [&] {
            while (at != end && *at == ' ')
                ++at;
        };
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (k > 0 && (at == end || *at++ != header_.dialect.delimiter)) return false;
            skip();
            const auto [behind, code] = std::from_chars(at, end, values_[k]);
            if (code != std::errc{} || !std::isfinite(values_[k])) return false;
            at = behind;
            skip();
        }
        return at == end;
    }

    void read_fields() {
        const std::vector<CsvField> row = fields();
        if (row.size() != values_.size())
            throw refusal(place_of(lines_.name(), *line_, row.back().column),
                          "the row has " + std::to_string(row.size()) + " columns",
                          "the first row has " + std::to_string(values_.size()));
        for (std::size_t k = 0; k < row.size(); ++k)
            values_[k] = header_.columns[k].role == Role::words ? std::numeric_limits<double>::quiet_NaN()
                                                                : number(row[k], header_.columns[k]);
    }

    double number(const CsvField& field, const SignalColumn& column) const {
        const std::optional<double> number = csv_table::number_in(field.text, header_.dialect);
        if (number && std::isfinite(*number)) return *number;
        const std::string what = (column.name.empty() ? "" : column.name + " = ") + "\"" + field.text + "\"";
        const base::Place place = place_of(lines_.name(), *line_, field.column);
        if (number) throw refusal(place, what + " is not a finite number");
        throw refusal(place, what + " is not a number", field.text.empty() ? "the field is empty" : "",
                      field.text.find(',') == std::string::npos ? "" : "Write the decimal mark as a point.");
    }

    TableHeader header_;
    LineReader lines_;
    std::optional<TextLine> line_;
    std::vector<double> values_;
    bool has_words_ = false;
};

// the numeral of the time in the last row that has one
std::optional<std::string> last_time(const SignalInput& input, const TableHeader& header, std::size_t column) {
    const std::uint64_t size = input.bytes->size();
    const std::uint64_t from = std::max(header.data_offset, size - std::min<std::uint64_t>(size, LineReader::longest));
    const std::string tail = text_at(*input.bytes, from, LineReader::longest);
    std::string_view rest = tail;
    while (!rest.empty()) {
        const std::size_t end = rest.find_last_of("\r\n");
        const std::string_view line = end == std::string_view::npos ? rest : rest.substr(end + 1);
        rest = rest.substr(0, end == std::string_view::npos ? 0 : end);
        if (!is_table_line(line)) continue;
        const std::vector<CsvField> fields = csv_table::split(line, header.dialect.delimiter);
        const bool is_whole = fields.size() >= header.columns.size() &&
                              csv_table::number_in(fields[column].text, header.dialect).has_value();
        if (!is_whole) return std::nullopt;
        return csv_table::numeral(fields[column].text, header.dialect);
    }
    return std::nullopt;
}

time_grid::Times times_of(const SignalInput& input, const TableHeader& header, std::size_t column) {
    const std::string& label = header.columns[column].unit;
    const FullScale unit = unit_of_label(label);
    time_grid::Times times;
    times.unit = unit.unit == "s" ? unit.value : 1.0;
    Rows rows(input, header);
    while (times.first.size() < looked_at) {
        const std::span<const double> row = rows.next();
        if (row.empty()) break;
        const double time = row[column];
        if (!times.first.empty() && !(time > times.first.back()))
            throw refusal(rows.place(column), "the times do not increase",
                          base::shortest(time) + " follows " + base::shortest(times.first.back()),
                          "Sort the rows by time, or print the times with more digits.");
        times.first.push_back(time);
        const std::string numeral = csv_table::numeral(rows.fields()[column].text, header.dialect);
        times.precision = time_grid::finer(times.precision, time_grid::precision_of(numeral));
    }
    times.last = times.first.back();
    if (const auto numeral = last_time(input, header, column)) {
        const double last = csv_table::number_in(*numeral, {'\0'}).value_or(times.last);
        if (std::isfinite(last) && last > times.first.back()) {
            times.last = last;
            times.precision = time_grid::finer(times.precision, time_grid::precision_of(*numeral));
        }
    }
    return times;
}

class SignalCsv final : public signal::Source {
public:
    SignalCsv(const SignalInput& input, const TableHeader& header, double rate, std::optional<time_grid::Times> times)
        : rows_(input, header),
          times_(std::move(times)) {
        layout_.rate = rate;
        for (std::size_t k = 0; k < header.columns.size(); ++k) {
            if (header.columns[k].role == Role::time) time_column_ = k;
            if (header.columns[k].role != Role::channel) continue;
            layout_.channels.push_back({header.columns[k].name, header.columns[k].unit});
            columns_.push_back(k);
        }
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = columns_.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        std::size_t count = 0;
        for (; count < frames.size() / width; ++count) {
            const std::span<const double> row = rows_.next();
            if (row.empty()) break;
            if (times_) check_time(row[time_column_]);
            for (std::size_t k = 0; k < width; ++k)
                frames[count * width + k] = row[columns_[k]];
            ++frames_;
        }
        return count;
    }

private:
    void check_time(double time) const {
        const std::optional<double> due = time_grid::missed(*times_, layout_.rate, frames_, time);
        if (!due) return;
        throw refusal(rows_.place(time_column_), "the times are not evenly spaced",
                      "at " + base::shortest(layout_.rate) + " Hz this row is due at " + base::shortest(*due) +
                          ", not at " + base::shortest(time),
                      "Resample the table to an even step.");
    }

    Rows rows_;
    std::optional<time_grid::Times> times_;
    signal::ChannelLayout layout_;
    std::vector<std::size_t> columns_;  // of the channels
    std::size_t time_column_ = 0;
    std::uint64_t frames_ = 0;  // read so far
};

SnappedRate rate_from(const time_grid::Times& times, const base::Place& place) {
    if (times.first.size() < 2)
        throw refusal(place, "one row does not tell the sampling rate", "", "Write \"# rate: 48000\" above the table.");
    const SnappedRate snapped = time_grid::rate_of(times);
    const bool is_rate = std::isfinite(snapped.rate) && snapped.rate > 0.0 && snapped.rate <= highest_rate;
    if (!is_rate) throw refusal(place, "the times give no sampling rate");
    return snapped;
}

}  // namespace

RawSignal open_signal_csv(const SignalInput& input, std::optional<double> rate) {
    TableHeader header = signal_table::read_header(input);
    RawSignal raw;
    raw.format = "CSV";
    raw.metadata = header.metadata;
    raw.notes = signal_table::find_words(header, input);
    if (!rate) rate = header.rate;
    const std::optional<std::size_t> time = signal_table::find_time(header, rate || header.spoken_rate);
    const base::Place place{input.name, header.data_number, 0, ""};
    std::optional<time_grid::Times> times;
    if (time) {
        header.columns[*time].role = Role::time;
        times = times_of(input, header, *time);
    }
    if (const std::size_t lines = header.prose_lines; lines > 0)
        raw.notes.push_back(std::to_string(lines) + (lines == 1 ? " line" : " lines") +
                            " of text above the table taken for metadata");
    if (!times && !rate) rate = header.spoken_rate;
    if (times && !rate) {
        const SnappedRate snapped = rate_from(*times, place);
        rate = snapped.rate;
        if (!snapped.note.empty()) raw.notes.push_back(snapped.note);
    }
    if (!rate)
        throw refusal(place, "the table does not tell its sampling rate", "it has no column of times",
                      "Write \"# rate: 48000\" above it, or name one column \"time\".");
    const bool has_channel = std::any_of(header.columns.begin(), header.columns.end(),
                                         [](const SignalColumn& column) { return column.role == Role::channel; });
    if (!has_channel) throw refusal(place, "the table has no column of samples");
    raw.source = std::make_unique<SignalCsv>(input, header, *rate, std::move(times));
    return raw;
}

}  // namespace stridor::recordings
