#include "stridor/recordings/table/signal_csv_header.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/refusal.hpp"
#include "stridor/recordings/table/table_start.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace stridor::recordings::signal_table {

namespace {

using csv_table::CsvField;
using csv_table::Dialect;

constexpr std::size_t most_columns = 4096;     // more is no table of signals
constexpr std::size_t most_metadata = 1000;    // `# key: value` lines that are kept
constexpr std::size_t looked_at = 300;         // lines in which the table must begin
constexpr std::size_t most_bytes = 1U << 20U;  // of these

bool is_rate_key(const std::string& key) {
    constexpr std::array<std::string_view, 7> known{"rate",        "sample rate",        "sampling rate", "sample_rate",
                                                    "sample freq", "sampling frequency", "abtastrate"};
    return std::find(known.begin(), known.end(), csv_table::lower(key)) != known.end();
}

// the tables that Stridor writes say in their first line what they are
void check_schema(const std::string& schema, const base::Place& place) {
    const bool is_other = schema.starts_with("stridor.") && schema != "stridor.signal/1" && schema != "stridor.trace/1";
    if (is_other)
        throw refusal(place, "this table of Stridor's holds no signal over time", "it is a \"" + schema + "\"",
                      "Write a motion with: stridor simulate CASE --trace FILE.csv");
}

void read_fact(TableHeader& header, std::string_view text, const base::Place& place) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return;
    const std::string key(base::trimmed(text.substr(0, colon)));
    const std::string value(base::trimmed(text.substr(colon + 1)));
    if (key == "schema") check_schema(value, place);
    if (is_rate_key(key)) {
        try {
            header.rate = base::parse_quantity(value, "Hz");
        } catch (const Error& error) {
            throw Error(error.kind(), error.problem(), place);
        }
        const bool is_rate = *header.rate > 0.0 && *header.rate <= highest_rate;
        if (!is_rate) throw refusal(place, "\"" + value + "\" is no sampling rate");
    } else if (header.metadata.size() < most_metadata) {
        header.metadata.emplace_back(key, value);
    }
}

void read_comment(TableHeader& header, const TextLine& line, const std::string& file) {
    std::string_view content = base::trimmed(line.text);
    if (!content.starts_with('#')) return;
    content = base::trimmed(content.substr(1));
    const base::Place place = place_of(file, line, 1);
    // Stridor puts all facts into one line
    const bool has_many = content.starts_with("schema: stridor.");
    while (!content.empty()) {
        const std::size_t end = has_many ? content.find(base::csv_text::fact_mark) : std::string_view::npos;
        read_fact(header, content.substr(0, end), place);
        content.remove_prefix(end == std::string_view::npos ? content.size() : end + base::csv_text::fact_mark.size());
    }
}

// "Sampling rate [Hz];51200" and "operator: Smith" above the table; nothing in prose is an error
void read_prose(TableHeader& header, const std::string& text) {
    ++header.prose_lines;
    const std::size_t mark = text.find_first_of(":=;\t,");
    if (mark == std::string::npos || header.metadata.size() >= most_metadata) return;
    const csv_table::Title title = csv_table::title_of(base::trimmed(std::string_view(text).substr(0, mark)));
    const std::string value(base::trimmed(csv_table::split(text.substr(mark + 1), text[mark])[0].text));
    if (title.name.empty() || value.empty()) return;
    if (!is_rate_key(title.name)) {
        header.metadata.emplace_back(title.name, title.unit.empty() ? value : value + " " + title.unit);
        return;
    }
    try {
        const bool has_unit = value.find_first_not_of("0123456789.,eE+-") != std::string::npos;
        const std::string number = csv_table::numeral(value, {';'});
        const double rate = base::parse_quantity(has_unit ? number : number + " " + title.unit, "Hz");
        if (rate > 0.0 && rate <= highest_rate) header.spoken_rate = rate;
    } catch (const Error&) {
        header.metadata.emplace_back(title.name, value);
    }
}

/// The first lines of a file: those of the table, and what stands between them.
struct Beginning {
    std::vector<std::string> texts;  // of the table, and of prose above it
    std::vector<TextLine> lines;     // their numbers and places; the text is in `texts`
    std::vector<std::pair<std::string, TextLine>> comments;
};

Beginning beginning_of(LineReader& lines) {
    Beginning beginning;
    for (std::size_t bytes = 0; bytes < most_bytes && beginning.texts.size() < looked_at;) {
        const auto line = lines.next();
        if (!line) break;
        bytes += line->text.size();
        if (is_table_line(line->text)) {
            beginning.texts.emplace_back(line->text);
            beginning.lines.push_back({{}, line->number, line->offset});
        } else if (base::trimmed(line->text).starts_with('#')) {
            beginning.comments.emplace_back(line->text, TextLine{{}, line->number, line->offset});
        }
    }
    return beginning;
}

// names in the first line, or none; what else cannot be a row of numbers is one of units
csv_table::TableStart plain_start(const Beginning& beginning, const base::Place& place) {
    const std::vector<std::string>& texts = beginning.texts;
    const bool has_delimiter = texts[0].find_first_of("\t;,") != std::string::npos;
    csv_table::TableStart start{has_delimiter ? csv_table::sniff(texts[0]) : Dialect{'\0'}, {}, {}, 0};
    const auto has_numbers = [&](std::size_t k) {
        return csv_table::is_number_row(csv_table::split(texts[k], start.dialect.delimiter), start.dialect);
    };
    if (has_numbers(0)) return start;
    start.names = 0;
    start.rows = 1;
    if (texts.size() > 1 && !has_numbers(1)) {
        start.units = 1;
        start.rows = 2;
    }
    if (texts.size() <= start.rows) throw refusal(place, "the table has no row of numbers");
    return start;
}

void read_columns(TableHeader& header, const csv_table::TableStart& start, const Beginning& beginning,
                  const base::Place& place) {
    const auto fields_in = [&](std::size_t line) {
        std::vector<CsvField> fields = csv_table::split(beginning.texts[line], start.dialect.delimiter);
        csv_table::drop_empty_tail(fields, 1);
        return fields;
    };
    std::vector<CsvField> fields = fields_in(start.first());
    csv_table::drop_comment(fields, fields_in(start.rows).size());
    if (fields.size() > most_columns)
        throw refusal(place, "the table has " + std::to_string(fields.size()) + " columns",
                      "at most " + std::to_string(most_columns) + " are read");
    header.columns.resize(fields.size());
    header.has_names = start.names.has_value();
    if (!header.has_names) return;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const csv_table::Title title = csv_table::title_of(fields[k].text);
        header.columns[k] = {title.name, std::string(base::trimmed(title.unit)), Role::channel};
    }
    if (!start.units) return;
    const std::vector<CsvField> units = fields_in(*start.units);
    for (std::size_t k = 0; k < std::min(units.size(), header.columns.size()); ++k)
        if (const auto unit = base::trimmed(csv_table::bare_unit(units[k].text)); !unit.empty())
            header.columns[k].unit = unit;
}

bool is_time(const SignalColumn& column) {
    return csv_table::is_time_name(column.name) || (!column.unit.empty() && unit_of_label(column.unit).unit == "s");
}

}  // namespace

bool is_table_line(std::string_view line) {
    const std::string_view content = base::trimmed(line);
    return !content.empty() && content.front() != '#';
}

std::optional<TextLine> next_row(LineReader& lines) {
    while (const auto line = lines.next())
        if (is_table_line(line->text)) return line;
    return std::nullopt;
}

TableHeader read_header(const SignalInput& input) {
    const std::string first_bytes = text_at(*input.bytes, 0, 4);
    if (csv_table::is_utf16(first_bytes))
        throw refusal({input.name, 1, 1, ""}, "the file is in UTF-16", "", "Save it as UTF-8.");
    const bool has_mark = first_bytes.starts_with(csv_table::utf8_mark);
    LineReader lines(input.bytes, input.name, has_mark ? csv_table::utf8_mark.size() : 0);
    const Beginning beginning = beginning_of(lines);
    TableHeader header;
    const int end = beginning.lines.empty() ? std::numeric_limits<int>::max() : beginning.lines[0].number;
    for (const auto& [text, line] : beginning.comments)
        if (line.number < end) read_comment(header, {text, line.number, line.offset}, input.name);
    if (beginning.texts.empty())
        throw refusal({input.name, 0, 0, ""}, "the file holds no table", "columns of numbers are expected");
    const auto place_in = [&](std::size_t k) {
        return place_of(input.name, {beginning.texts[k], beginning.lines[k].number, beginning.lines[k].offset}, 1);
    };
    const std::optional<csv_table::TableStart> found = csv_table::find_start(beginning.texts);
    const csv_table::TableStart start = found ? *found : plain_start(beginning, place_in(0));
    for (std::size_t k = 0; k < start.first(); ++k)
        read_prose(header, beginning.texts[k]);
    header.dialect = start.dialect;
    header.data_offset = beginning.lines[start.rows].offset;
    header.data_number = beginning.lines[start.rows].number;
    read_columns(header, start, beginning, place_in(start.first()));
    return header;
}

std::vector<std::string> find_words(TableHeader& header, const SignalInput& input) {
    LineReader lines(input.bytes, input.name, header.data_offset, header.data_number);
    const std::optional<TextLine> row = next_row(lines);
    if (!row) return {};
    const std::vector<CsvField> fields = csv_table::split(row->text, header.dialect.delimiter);
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < std::min(fields.size(), header.columns.size()); ++k) {
        const bool is_words = !fields[k].text.empty() && !csv_table::number_in(fields[k].text, header.dialect);
        if (!is_words) continue;
        header.columns[k].role = Role::words;
        notes.push_back("the column \"" + header.columns[k].name + "\" holds words and was left out");
    }
    return notes;
}

std::optional<std::size_t> find_time(const TableHeader& header, bool is_rate_known) {
    for (std::size_t k = 0; k < header.columns.size(); ++k)
        if (header.columns[k].role == Role::channel && is_time(header.columns[k])) return k;
    const bool is_first = !header.has_names && !is_rate_known && header.columns.size() > 1;
    return is_first ? std::optional<std::size_t>(0) : std::nullopt;
}

}  // namespace stridor::recordings::signal_table
