#include "stridor/io/signal_csv_header.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/calibration.hpp"
#include "stridor/io/refusal.hpp"

#include <algorithm>

namespace stridor::io::signal_table {

namespace {

using csv_table::Dialect;
using csv_table::Field;

constexpr std::size_t most_columns = 4096;   // more is no table of signals
constexpr std::size_t most_metadata = 1000;  // `# key: value` lines that are kept

void read_comment(Header& header, const Line& line, const std::string& file) {
    std::string_view content = base::trimmed(line.text);
    if (!content.starts_with('#')) return;
    content.remove_prefix(1);
    const std::size_t colon = content.find(':');
    if (colon == std::string_view::npos) return;
    const std::string key(base::trimmed(content.substr(0, colon)));
    const std::string value(base::trimmed(content.substr(colon + 1)));
    const std::string small = csv_table::lower(key);
    if (small == "rate" || small == "sample rate" || small == "sampling rate" || small == "sample_rate") {
        try {
            header.rate = base::parse_quantity(value, "Hz");
        } catch (const Error& error) {
            throw Error(error.kind(), error.problem(), place_of(file, line, 1));
        }
        const bool is_rate = *header.rate > 0.0 && *header.rate <= highest_rate;
        if (!is_rate) throw refusal(place_of(file, line, 1), "\"" + value + "\" is no sampling rate");
    } else if (header.metadata.size() < most_metadata) {
        header.metadata.emplace_back(key, value);
    }
}

// names, units and roles; `first` is the first line of the table
void read_columns(Header& header, LineReader& lines, const Line& first) {
    const bool has_delimiter = first.text.find_first_of("\t;,") != std::string_view::npos;
    header.dialect = has_delimiter ? csv_table::sniff(first.text) : Dialect{'\0'};
    header.data_offset = first.offset;
    header.data_number = first.number;
    std::vector<Field> fields = csv_table::split(first.text, header.dialect.delimiter);
    csv_table::drop_empty_tail(fields, 1);
    if (fields.size() > most_columns)
        throw refusal(place_of(lines.name(), first, 1), "the table has " + std::to_string(fields.size()) + " columns",
                      "at most " + std::to_string(most_columns) + " are read");
    header.columns.resize(fields.size());
    header.has_names = !csv_table::is_number_row(fields, header.dialect);
    if (!header.has_names) return;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const csv_table::Title title = csv_table::title_of(fields[k].text);
        header.columns[k] = {title.name, std::string(base::trimmed(title.unit)), Role::channel};
    }
    const base::Place titles = place_of(lines.name(), first, 1);
    std::optional<Line> row = next_row(lines);
    if (!row) throw refusal(titles, "the table has no row of numbers");
    std::vector<Field> units = csv_table::split(row->text, header.dialect.delimiter);
    if (!csv_table::is_number_row(units, header.dialect)) {
        for (std::size_t k = 0; k < std::min(units.size(), header.columns.size()); ++k)
            if (const auto unit = base::trimmed(csv_table::bare_unit(units[k].text)); !unit.empty())
                header.columns[k].unit = unit;
        row = next_row(lines);
    }
    if (!row) throw refusal(titles, "the table has no row of numbers");
    header.data_offset = row->offset;
    header.data_number = row->number;
}

bool is_time(const Column& column) {
    const std::string name = csv_table::lower(column.name);
    return name == "time" || name == "t" || (!column.unit.empty() && unit_of_label(column.unit).unit == "s");
}

}  // namespace

bool is_table_line(std::string_view line) {
    const std::string_view content = base::trimmed(line);
    return !content.empty() && content.front() != '#';
}

std::optional<Line> next_row(LineReader& lines) {
    while (const auto line = lines.next())
        if (is_table_line(line->text)) return line;
    return std::nullopt;
}

Header read_header(const SignalInput& input) {
    const std::string beginning = text_at(*input.bytes, 0, 4);
    if (csv_table::is_utf16(beginning))
        throw refusal({input.name, 1, 1, ""}, "the file is in UTF-16", "", "Save it as UTF-8.");
    const bool has_mark = beginning.starts_with(csv_table::utf8_mark);
    LineReader lines(input.bytes, input.name, has_mark ? csv_table::utf8_mark.size() : 0);
    Header header;
    while (const auto line = lines.next()) {
        if (is_table_line(line->text)) {
            // the text of the line is gone once the reader goes on
            const std::string text(line->text);
            read_columns(header, lines, {text, line->number, line->offset});
            return header;
        }
        read_comment(header, *line, input.name);
    }
    throw refusal({input.name, 0, 0, ""}, "the file holds no table", "columns of numbers are expected");
}

std::vector<std::string> find_words(Header& header, const SignalInput& input) {
    LineReader lines(input.bytes, input.name, header.data_offset, header.data_number);
    const std::optional<Line> row = next_row(lines);
    if (!row) return {};
    const std::vector<Field> fields = csv_table::split(row->text, header.dialect.delimiter);
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < std::min(fields.size(), header.columns.size()); ++k) {
        const bool is_words = !fields[k].text.empty() && !csv_table::number_in(fields[k].text, header.dialect);
        if (!is_words) continue;
        header.columns[k].role = Role::words;
        notes.push_back("the column \"" + header.columns[k].name + "\" holds words and was left out");
    }
    return notes;
}

std::optional<std::size_t> find_time(const Header& header, bool is_rate_known) {
    for (std::size_t k = 0; k < header.columns.size(); ++k)
        if (header.columns[k].role == Role::channel && is_time(header.columns[k])) return k;
    const bool is_first = !header.has_names && !is_rate_known && header.columns.size() > 1;
    return is_first ? std::optional<std::size_t>(0) : std::nullopt;
}

}  // namespace stridor::io::signal_table
