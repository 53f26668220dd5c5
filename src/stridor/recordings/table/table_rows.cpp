#include "stridor/recordings/table/table_rows.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/refusal.hpp"
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

// what instruments and spreadsheets write where they have no value, if nothing else in the column is nearly as large
constexpr std::array value_marks{999.0, 9999.0, 99999.0, 999999.0, 9999999.0, 32768.0};

bool is_value_mark(double x) {
    return std::find(value_marks.begin(), value_marks.end(), std::abs(x)) != value_marks.end();
}

/// Gathers what is in a column.
class Surveyor {
public:
    explicit Surveyor(ColumnSurvey& column) : column_(column) {}

    void push(double x) {
        ColumnSurvey& c = column_;
        if (is_value_mark(x) && (c.marks == 0 || x == c.mark)) {
            c.mark = x;
            ++c.marks;
        } else {
            c.largest = std::max(c.largest, std::abs(x));
        }
        if (c.numbers == 0) c.first = x;
        if (c.numbers == 1) c.second = x;
        if (c.numbers > 0) {
            const double step = c.second - c.first;
            c.is_rising = c.is_rising && x > c.last;
            c.is_even = c.is_even && step != 0.0 && std::abs(x - c.last - step) <= 0.1 * std::abs(step);
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
      end_(header.end_number),
      lines_(input.bytes, input.name, header.data_offset, header.data_number),
      values_(header.columns.size()),
      last_number_(header.data_number - 1) {}

std::span<const double> TableRows::next() {
    if (line_) last_number_ = line_->number;
    line_ = next_row(lines_);
    if (!line_ || (end_ > 0 && line_->number >= end_)) return {};
    is_text_ = false;
    if (!read_plain()) read_fields();
    return values_;
}

std::vector<CsvField> TableRows::fields() const {
    std::vector<CsvField> fields = csv_table::split(line_->text, dialect_.delimiter);
    csv_table::drop_empty_tail(fields, values_.size());
    return fields;
}

base::Place TableRows::place(std::size_t column) const {
    const std::vector<CsvField> row = fields();
    return place_of(lines_.name(), *line_, row[std::min(column, row.size() - 1)].column);
}

// the usual row, without words, quotes and decimal commas; false for any other
bool TableRows::read_plain() {
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
    const std::vector<CsvField> row = fields();
    const bool has_number = csv_table::is_number_row(row, dialect_);
    // a word in a single column is a damaged row, unless a blank line parts it
    is_text_ = !has_number && (values_.size() > 1 || line_->number > last_number_ + 1);
    if (is_text_) return;
    if (row.size() != values_.size())
        throw refusal(place_of(lines_.name(), *line_, row.back().column),
                      "the row has " + std::to_string(row.size()) + " columns",
                      "the first row has " + std::to_string(values_.size()),
                      "Give every row as many fields, empty ones where there is no number.");
    for (std::size_t k = 0; k < row.size(); ++k)
        values_[k] = sample_or_nothing(csv_table::value_in(row[k].text, dialect_).value_or(nothing));
}

TableSurvey surveyed(const SignalInput& input, const TableHeader& header) {
    TableSurvey survey;
    survey.columns.resize(header.columns.size());
    std::optional<base::Place> text;
    for (TableRows rows(input, header);;) {
        const std::span<const double> row = rows.next();
        if (row.empty()) return survey;
        if (rows.is_text()) {
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
