#include "stridor/recordings/table/signal_csv.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/csv_text.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/column_roles.hpp"
#include "stridor/recordings/table/csv_table.hpp"
#include "stridor/recordings/table/instants.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/table/table_rows.hpp"
#include "stridor/recordings/table/table_start.hpp"
#include "stridor/recordings/time_grid.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stridor::recordings {

namespace {

using csv_table::CsvField;
using signal_table::highest_rate;
using signal_table::is_table_line;
using signal_table::Role;
using signal_table::TableHeader;
using signal_table::TableRows;

// the time in the last row that has one
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
                              csv_table::value_in(fields[column].text, header.dialect).has_value();
        if (!is_whole) return std::nullopt;
        return fields[column].text;
    }
    return std::nullopt;
}

// how finely a time is printed; of clocks, how finely their second is
time_grid::Precision precision_of(const std::string& field, csv_table::Dialect dialect) {
    const auto instant = csv_table::instant_in(field);
    return instant ? time_grid::Precision{instant->decimals, 16}
                   : time_grid::precision_of(csv_table::numeral(field, dialect));
}

time_grid::Times times_of(const SignalInput& input, const TableHeader& header, std::size_t column) {
    const std::string& label = header.columns[column].unit;
    const FullScale unit = unit_of_label(label);
    time_grid::Times times;
    times.unit = unit.unit == "s" ? unit.value : 1.0;
    TableRows rows(input, header);
    while (times.first.size() < time_grid::looked_at) {
        const std::span<const double> row = rows.next();
        if (row.empty()) break;
        const double time = row[column];
        if (!times.first.empty() && !(time > times.first.back()))
            throw refusal(
                rows.place(column), "the times do not increase",
                base::shortest(time) + " follows " + base::shortest(times.first.back()),
                "Sort the rows by time, or print the times with more digits, or give the rate: --rate 48000.");
        times.first.push_back(time);
        times.precision = time_grid::finer(times.precision, precision_of(rows.fields()[column].text, header.dialect));
    }
    times.last = times.first.back();
    if (const auto field = last_time(input, header, column)) {
        const double last = csv_table::value_in(*field, header.dialect).value_or(times.last);
        if (std::isfinite(last) && last > times.first.back()) {
            times.last = last;
            times.precision = time_grid::finer(times.precision, precision_of(*field, header.dialect));
        }
    }
    return times;
}

// are the times those of clocks?
bool has_clock(const SignalInput& input, const TableHeader& header, std::size_t column) {
    TableRows rows(input, header);
    return !rows.next().empty() && csv_table::instant_in(rows.fields()[column].text);
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
                      "Resample the table to an even step, or give the rate that it was meant to have: --rate " +
                          base::shortest(layout_.rate) + ".");
    }

    TableRows rows_;
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
    if (!is_rate)
        throw refusal(place, "the times give no sampling rate", base::shortest(snapped.rate) + " Hz is none",
                      "Write the unit of the times into their heading.");
    return snapped;
}

constexpr double earliest_epoch = 1e9;  // [s] since 1970, in 2001

// of times without a unit: nobody measured in the year 30,000, so that numbers so large are no seconds since 1970
double epoch_unit(double first) {
    constexpr double latest = 4.2e9;  // [s] 2103
    for (const double unit : {1e-3, 1e-6, 1e-9})
        if (first * unit >= earliest_epoch && first * unit < latest) return unit;
    return 1.0;
}

std::string hertz(double rate) {
    return base::shortest(rate) + " Hz";
}

// column 3, "acc" in m/s2
std::string shown_column(const TableHeader& header, std::size_t k) {
    const signal_table::SignalColumn& column = header.columns[k];
    return "column " + std::to_string(k + 1) + (column.name.empty() ? "" : ", \"" + column.name + "\"") +
           (column.unit.empty() ? "" : " in " + column.unit);
}

/// The rates that are told in different places, held against each other.
struct RateFinder {
    std::optional<double> given;  // [Hz] by an option
    const TableHeader& header;
    base::Place place;  // of the first row
    bool lack_unit;     // the times
    std::vector<std::string>& notes;

    /// The rate; a rate by an option outranks the times, which are left out then.
    std::optional<double> find(std::optional<time_grid::Times>& times) const {
        const std::optional<double> said = header.rate ? header.rate : header.spoken_rate;
        if (!times || (times->first.size() < 2 && (given || said))) return given ? given : said;
        const SnappedRate snapped = rate_from(*times, place);
        const auto agrees = [&](double rate) { return std::abs(rate / snapped.rate - 1.0) <= 0.01; };
        if (given) {
            notes.push_back("the times " + (agrees(*given) ? "" : "tell " + hertz(snapped.rate) + " and ") +
                            "were left out, as --rate tells " + hertz(*given));
            times.reset();
            return given;
        }
        if (said && !agrees(*said))
            throw refusal(place, "the table contradicts itself",
                          "above it the rate is " + hertz(*said) + ", its times tell " + hertz(snapped.rate),
                          "Say which one is right: --rate " + base::shortest(*said) + ", or --rate " +
                              base::shortest(snapped.rate) + ".");
        if (header.rate) return header.rate;
        if (lack_unit && !said) take_for_seconds(times->first, snapped.rate);
        if (!snapped.note.empty()) notes.push_back(snapped.note);
        return snapped.rate;
    }

private:
    // 0, 1, 2 may be seconds or milliseconds, or number the rows
    void take_for_seconds(const std::vector<double>& first, double rate) const {
        const auto is_whole = [&](double time) { return std::fmod(time - first.front(), 1.0) == 0.0; };
        if (std::all_of(first.begin(), first.end(), is_whole))
            throw refusal(place, "the times have no unit", "in seconds the rate would be " + hertz(rate),
                          "Write it into the heading, as \"time [ms]\", or say the sampling rate: --rate " +
                              base::shortest(1e3 * rate) + " for milliseconds, --rate " + base::shortest(rate) +
                              " for seconds.");
        notes.emplace_back("the times have no unit and were taken for seconds");
    }
};

// what was met between the rows
void note_met(const TableRows::Met& met, char grouping, RawSignal& raw) {
    const auto rows = [](std::size_t count) { return std::to_string(count) + (count == 1 ? " row" : " rows"); };
    if (met.comments > 0) {
        raw.left_out.push_back("remarks behind the columns: in " + rows(met.comments));
        raw.notes.push_back("the remarks behind the columns, in " + rows(met.comments) + ", were left out");
    }
    if (met.grouped > 0)
        raw.notes.push_back(std::string("a ") + (grouping == '.' ? "point" : "comma") +
                            " was taken for a mark between thousands " + std::to_string(met.grouped) +
                            " times, as the other mark is the decimal one");
    if (met.headings > 0)
        raw.notes.push_back("the table has " + std::to_string(met.headings + 1) +
                            " parts with a heading each, and was read as one without gaps");
}

// the times that are there and are not read
std::string why_no_times(const TableHeader& header, const signal_table::TableSurvey& survey) {
    for (std::size_t k = 0; k < header.columns.size(); ++k)
        if (header.columns[k].role == Role::words && csv_table::is_time_name(header.columns[k].name))
            return "the times of \"" + header.columns[k].name + "\", as \"" + survey.columns[k].trouble_text +
                   "\", are not read";
    return "it has no column of times" + (survey.end == 0 ? "" : "; behind it stands \"" + survey.text_behind + "\"");
}

constexpr std::size_t csv_block = 1U << 12U;

// names of channels have no line ends and quotes here: the reader takes a row for a line
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '"'; }, ' ');
    return text;
}

// a column without a unit is read as one of full scale, so that of a dimensionless signal says so
std::string heading(const signal::Channel& channel, std::size_t number) {
    const std::string name = channel.name.empty() ? "channel " + std::to_string(number) : channel.name;
    return one_line(name + " [" + channel.unit + "]");
}

base::csv_text::Table table_of(const signal::ChannelLayout& layout) {
    base::csv_text::Facts facts = base::csv_text::origin("signal");
    facts.emplace_back("rate", base::shortest(layout.rate) + " Hz");
    std::vector<base::csv_text::TableColumn> columns{{"time", "s"}};
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        columns.push_back({heading(layout.channels[k], k + 1)});
    return base::csv_text::Table(facts, columns);
}

}  // namespace

RawSignal open_signal_csv(const SignalInput& input, std::optional<double> rate, const std::string& wanted) {
    TableHeader header = signal_table::read_header(input);
    RawSignal raw;
    raw.format = "CSV";
    raw.metadata = header.metadata;
    const signal_table::TableSurvey survey = signal_table::surveyed(input, header);
    header.end_number = survey.end;
    const bool is_said = header.rate || header.spoken_rate;
    raw.notes = signal_table::assign_roles(header, survey, {rate.has_value(), is_said, wanted, input.name});
    note_met(survey.met, header.dialect.grouping, raw);
    if (survey.end > 0)
        raw.notes.push_back("the text behind the table, from line " + std::to_string(survey.end) + " (\"" +
                            survey.text_behind + "\") on, was left out");
    const base::Place place{input.name, header.data_number, 0, ""};
    std::optional<time_grid::Times> times;
    bool lack_unit = false;
    const std::optional<std::size_t> time = signal_table::time_column(header);
    for (std::size_t k = 0; k < header.columns.size(); ++k)
        if (!header.columns[k].why.empty())
            raw.left_out.push_back(shown_column(header, k) + ": " + header.columns[k].why);
    if (time && rate && !survey.columns[*time].is_rising) {
        raw.notes.push_back("the times do not increase and were left out, as --rate tells " + hertz(*rate));
    } else if (time) {
        times = times_of(input, header, *time);
        if (header.columns[*time].unit.empty()) times->unit = epoch_unit(times->first.front());
        lack_unit = header.columns[*time].unit.empty() && times->unit == 1.0 && times->first.front() < earliest_epoch &&
                    !has_clock(input, header, *time);
        if (times->unit != 1.0 && header.columns[*time].unit.empty())
            raw.notes.push_back("the times were taken for " +
                                std::string(times->unit == 1e-3   ? "milliseconds"
                                            : times->unit == 1e-6 ? "microseconds"
                                                                  : "nanoseconds") +
                                " since 1970");
    }
    if (const std::size_t lines = header.prose_lines; lines > 0)
        raw.notes.push_back(std::to_string(lines) + (lines == 1 ? " line" : " lines") +
                            " of text above the table taken for metadata");
    const std::optional<double> found = RateFinder{rate, header, place, lack_unit, raw.notes}.find(times);
    if (times) raw.time = shown_column(header, *time);
    const std::string& first = header.columns.front().name;
    if (!found && csv_table::lower(first).starts_with("freq"))
        throw refusal(place, "the table is a spectrum", "it is over \"" + first + "\", and has no sound",
                      "Export the time history.");
    if (!found)
        throw refusal(place, "the table does not tell its sampling rate", why_no_times(header, survey),
                      "Write \"# rate: 48000\" above it, name one column \"time\", or say --rate.");
    raw.source = std::make_unique<SignalCsv>(input, header, *found, std::move(times));
    return raw;
}

std::uint64_t write_signal_csv(const std::string& path, signal::Source& source) {
    storage::PiecewiseFile file(path);
    const signal::ChannelLayout& layout = source.layout();
    const std::size_t width = layout.channels.size();
    base::csv_text::Table table = table_of(layout);
    file.write(table.take());
    std::vector<double> block(csv_block * width);
    std::uint64_t frames = 0;
    while (const std::size_t count = source.read(block)) {
        for (std::size_t frame = 0; frame < count; ++frame, ++frames) {
            table.number(static_cast<double>(frames) / layout.rate);
            for (std::size_t channel = 0; channel < width; ++channel)
                table.number(block[frame * width + channel]);
            table.end_row();
        }
        file.write(table.take());
    }
    file.commit();
    return frames;
}

}  // namespace stridor::recordings
