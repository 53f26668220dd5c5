#include "stridor/recordings/table/table_rows.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/signal/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace stridor::recordings::signal_table {

using csv_table::CsvField;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// 9.9E+37 is an overload, 9.91E+37 no value (SCPI)
double sample_or_nothing(double number) {
    return signal::is_sample(number) ? number : nothing;
}

// what instruments and spreadsheets write where they have no value
bool may_mark_no_value(double x) {
    constexpr std::array marks{999.0,   999.25,  9999.0,  99999.0,   999999.0,
                               32767.0, 32768.0, 65535.0, 9999999.0, 2147483647.0};
    constexpr double unmeasured = 1e15;  // [any unit] nothing that is measured is as large: 1E+20, 1E+30
    const double size = std::abs(x);
    return size >= marks.front() && (size >= unmeasured || std::find(marks.begin(), marks.end(), size) != marks.end());
}

/// Gathers what is in a column.
class Surveyor {
public:
    explicit Surveyor(ColumnSurvey& column) : column_(column) {}

    void push(double x) {
        ColumnSurvey& c = column_;
        constexpr std::size_t most_marks = 8;
        if (may_mark_no_value(x) && (c.marks.size() < most_marks || c.marks.contains(x)))
            ++c.marks[x];
        else
            c.largest = std::max(c.largest, std::abs(x));
        c.is_whole = c.is_whole && x == std::floor(x);
        if (c.numbers == 0) c.first = x;
        if (c.numbers == 1) c.second = x;
        if (c.numbers > 0) {
            const double step = c.second - c.first;
            c.is_rising = c.is_rising && x > c.last;
            c.is_even = c.is_even && step != 0.0 && std::abs(x - c.last - step) <= 0.1 * std::abs(step);
            c.rests += x == c.last ? 1 : 0;
            c.ups += x - c.last == 1.0 ? 1 : 0;
            c.downs += x - c.last == -1.0 ? 1 : 0;
        }
        c.last = x;
        ++c.numbers;
    }

private:
    ColumnSurvey& column_;
};

}  // namespace

TableRows::TableRows(const SignalInput& input, const TableHeader& header)
    : dialect_(header.dialect),
      has_comment_(header.has_comment),
      heading_(header.heading),
      end_(header.end_number),
      lines_(input.bytes, input.name, header.data_offset, header.data_number),
      values_(header.columns.size()),
      last_number_(header.data_number - 1) {}

std::span<const double> TableRows::next() {
    if (line_) last_number_ = line_->number;
    line_ = next_row(lines_);
    if (line_ && !heading_.names.empty() && line_->text.starts_with("Channels")) skip_heading();
    if (!line_ || (end_ > 0 && line_->number >= end_)) return {};
    is_text_ = false;
    if (!read_plain()) read_fields();
    return values_;
}

// Multi_Headings: what LabVIEW writes at each turn is read on where it is of the same channels
void TableRows::skip_heading() {
    const base::Place begin = place_of(lines_.name(), *line_, 1);
    bool is_alike = true;
    while (line_ && !line_->text.starts_with(heading_end)) {
        is_alike = is_alike && (!line_->text.starts_with("Delta_X") || line_->text == heading_.steps);
        line_ = next_row(lines_);
    }
    if (line_) line_ = next_row(lines_);
    if (line_ && (!is_alike || line_->text != heading_.names))
        throw refusal(begin, "here begin other channels, or others' steps", "the parts of a file are read as one",
                      "Write each part into a file of its own.");
    if (line_) line_ = next_row(lines_);
    ++met_.headings;
}

std::vector<CsvField> TableRows::fields() const {
    std::vector<CsvField> fields = csv_table::split(line_->text, dialect_.delimiter);
    if (has_comment_ && fields.size() == values_.size() + 1) fields.pop_back();
    csv_table::drop_empty_tail(fields, values_.size());
    return fields;
}

base::Place TableRows::place(std::size_t column) const {
    const std::vector<CsvField> row = fields();
    return place_of(lines_.name(), *line_, row[std::min(column, row.size() - 1)].column);
}

// the usual row, without words, quotes and decimal commas; false for any other
bool TableRows::read_plain() {
    if (dialect_.grouping == '.') return false;
    const char* at = line_->text.data();
    const char* const end = at + line_->text.size();
    const auto skip = [&] {
        while (at != end && *at == ' ')
            ++at;
    };
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (k > 0 && dialect_.delimiter != ' ' && (at == end || *at++ != dialect_.delimiter)) return false;
        skip();
        const auto [behind, code] = std::from_chars(at, end, values_[k]);
        if (code != std::errc{} || !signal::is_sample(values_[k])) return false;
        at = behind;
        // numbers that touch are not parted by blanks
        if (dialect_.delimiter == ' ' && at != end && *at != ' ') return false;
        skip();
    }
    return at == end;
}

void TableRows::read_fields() {
    std::vector<CsvField> row = csv_table::split(line_->text, dialect_.delimiter);
    if (has_comment_ && row.size() == values_.size() + 1) {
        met_.comments += row.back().text.empty() ? 0U : 1U;
        row.pop_back();
    }
    csv_table::drop_empty_tail(row, values_.size());
    const bool has_number = csv_table::is_number_row(row, dialect_);
    // a word in a single column is a damaged row, unless a blank line parts it
    is_text_ = !has_number && (values_.size() > 1 || line_->number > last_number_ + 1);
    if (is_text_) return;
    if (row.size() != values_.size())
        throw refusal(place_of(lines_.name(), *line_, row.back().column),
                      "the row has " + std::to_string(row.size()) + " columns",
                      "the first row has " + std::to_string(values_.size()),
                      "Give every row as many fields, empty ones where there is no number.");
    for (std::size_t k = 0; k < row.size(); ++k) {
        values_[k] = sample_or_nothing(csv_table::value_in(row[k].text, dialect_).value_or(nothing));
        const bool is_grouped = dialect_.grouping != '\0' && row[k].text.find(dialect_.grouping) != std::string::npos &&
                                csv_table::tells_grouping(row[k].text);
        met_.grouped += is_grouped ? 1U : 0U;
    }
}

// "Max,1.0" behind the rows: a word where the times stood
bool begins_summary(const TableSurvey& survey, std::span<const double> row, const TableRows& rows,
                    csv_table::Dialect dialect) {
    const ColumnSurvey& first = survey.columns.front();
    if (row.size() < 2 || !std::isnan(row.front()) || survey.rows < 3 || first.numbers != survey.rows ||
        !first.is_rising)
        return false;
    const std::string field = rows.fields().front().text;
    return !field.empty() && !csv_table::value_in(field, dialect);
}

TableSurvey surveyed(const SignalInput& input, const TableHeader& header) {
    TableSurvey survey;
    survey.columns.resize(header.columns.size());
    std::optional<base::Place> text;
    for (TableRows rows(input, header);;) {
        const std::span<const double> row = rows.next();
        survey.met = rows.met();
        if (row.empty()) return survey;
        if (rows.is_text() || begins_summary(survey, row, rows, header.dialect)) {
            if (!text) {
                text = rows.place(0);
                survey.end = rows.number();
                survey.text_behind = std::string(base::trimmed(text->source_line));
            }
            continue;
        }
        if (text)
            throw refusal(*text, "the table is interrupted by text",
                          "numbers follow in line " + std::to_string(rows.number()),
                          "Keep one table in the file, and delete the line.");
        ++survey.rows;
        std::optional<std::vector<CsvField>> fields;
        for (std::size_t k = 0; k < row.size(); ++k) {
            ColumnSurvey& column = survey.columns[k];
            if (!std::isnan(row[k])) {
                Surveyor(column).push(row[k]);
                continue;
            }
            if (!fields) fields = rows.fields();
            const std::string& field = (*fields)[k].text;
            if (field.empty()) ++column.empty;
            if (column.trouble) continue;
            column.trouble = rows.place(k);
            column.trouble_text = field;
        }
    }
}

}  // namespace stridor::recordings::signal_table
