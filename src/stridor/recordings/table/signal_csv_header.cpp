#include "stridor/recordings/table/signal_csv_header.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/table_start.hpp"
#include "stridor/recordings/time_grid.hpp"

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

// "Sample_Rate" and "sample rate" are one key
std::string plain_key(std::string_view key) {
    std::string plain = csv_table::lower(key);
    std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    return plain;
}

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& known, std::string_view key) {
    return std::find(known.begin(), known.end(), plain_key(key)) != known.end();
}

bool is_rate_key(std::string_view key) {
    constexpr std::array<std::string_view, 15> known{"rate",
                                                     "fs",
                                                     "srate",
                                                     "samplerate",
                                                     "samplingrate",
                                                     "samplefreq",
                                                     "samplingfreq",
                                                     "samplefrequency",
                                                     "samplingfrequency",
                                                     "scanrate",
                                                     "acquisitionrate",
                                                     "datarate",
                                                     "abtastrate",
                                                     "abtastfrequenz",
                                                     "messrate"};
    return is_one_of(known, key);
}

// the time from one row to the next, as LabVIEW and oscilloscopes call it
bool is_step_key(std::string_view key) {
    constexpr std::array<std::string_view, 16> known{"deltax",          "dt",
                                                     "deltat",          "tinc",
                                                     "increment",       "xincrement",
                                                     "xincr",           "timestep",
                                                     "timeincrement",   "timeinterval",
                                                     "sampleinterval",  "samplinginterval",
                                                     "sampleperiod",    "samplingperiod",
                                                     "abtastintervall", "abtastzeit"};
    return is_one_of(known, key);
}

// the tables that Stridor writes say in their first line what they are
void check_schema(const std::string& schema, const base::Place& place) {
    const bool is_other = schema.starts_with("stridor.") && schema != "stridor.signal/1" && schema != "stridor.trace/1";
    if (is_other)
        throw refusal(place, "this table of Stridor's holds no signal over time", "it is a \"" + schema + "\"",
                      "Write a motion with: stridor simulate CASE --trace FILE.csv");
}

// "0,000250" and "4e-6" behind the key, "s" or nothing behind it
std::optional<double> step_in(const std::vector<CsvField>& fields, const std::string& unit) {
    for (std::size_t k = 1; k < fields.size(); ++k) {
        std::string label = unit;
        std::string numeral = fields[k].text;
        if (const std::size_t blank = numeral.find(' '); blank != std::string::npos) {
            label = numeral.substr(blank + 1);
            numeral.resize(blank);
        }
        const std::optional<double> number = csv_table::number_in(numeral, {';'});
        if (!number) continue;
        const bool has_unit = label.empty() && k + 1 < fields.size() && unit_of_label(fields[k + 1].text).unit == "s";
        if (has_unit) label = fields[k + 1].text;
        const FullScale scale = unit_of_label(label);
        const double step = *number * (label.empty() ? 1.0 : scale.value);
        const bool is_step = (label.empty() || scale.unit == "s") && step >= 1.0 / highest_rate && step <= 1e9;
        return is_step ? std::optional(step) : std::nullopt;
    }
    return std::nullopt;
}

void read_spoken_step(TableHeader& header, const std::vector<CsvField>& fields, const std::string& unit) {
    header.spoken_steps.clear();
    for (const CsvField& field : fields)
        header.spoken_steps.push_back(csv_table::number_in(field.text, {';'}).value_or(0.0));
    if (const std::optional<double> step = step_in(fields, unit))
        header.spoken_rate = snapped_rate(*step, step_tolerance(fields[1].text)).rate;
}

// "48,000 Hz" is 48 kHz in English and 48 Hz in German
bool may_be_thousands(std::string_view numeral) {
    const std::size_t comma = numeral.find(',');
    const std::size_t end = std::min(numeral.find_first_not_of("0123456789,."), numeral.size());
    return comma != std::string_view::npos && comma < 4 && numeral.front() != '0' && end - comma == 4 &&
           numeral.find('.') >= end;
}

// "51,2 kHz", or its unit in the key; throws for what is no frequency
double rate_in(const std::string& value, const std::string& unit) {
    const std::size_t end = std::min(value.find_first_not_of("0123456789.,eE+-"), value.size());
    const std::string number = value.substr(0, end);
    const std::string plain = may_be_thousands(value) ? number : csv_table::numeral(number, {';'});
    return base::parse_quantity(plain + (end < value.size() ? value.substr(end) : " " + unit), "Hz");
}

bool is_rate(double rate) {
    return rate > 0.0 && rate <= highest_rate;
}

void read_fact(TableHeader& header, std::string_view text, const base::Place& place) {
    const std::size_t colon = text.find(':');
    const std::size_t mark = colon == std::string_view::npos ? text.find('=') : colon;
    if (mark == std::string_view::npos) return;
    const csv_table::Title key = csv_table::title_of(base::trimmed(text.substr(0, mark)));
    const std::string value(base::trimmed(text.substr(mark + 1)));
    if (key.name == "schema") check_schema(value, place);
    if (is_rate_key(key.name)) {
        try {
            header.rate = rate_in(value, key.unit);
        } catch (const Error& error) {
            throw Error(error.kind(), error.problem(), place);
        }
        if (!is_rate(*header.rate)) throw refusal(place, "\"" + value + "\" is no sampling rate");
    } else if (header.metadata.size() < most_metadata) {
        header.metadata.emplace_back(base::trimmed(text.substr(0, mark)), value);
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
    const std::size_t first = text.find_first_not_of(";%/! \t");  // marks of comments
    const std::size_t mark = text.find_first_of(":=;\t,", std::min(first, text.size()));
    if (mark == std::string::npos || header.metadata.size() >= most_metadata) return;
    const csv_table::Title title =
        csv_table::title_of(base::trimmed(std::string_view(text).substr(first, mark - first)));
    std::vector<CsvField> fields = csv_table::split(text.substr(mark), text[mark]);
    const std::string& value = fields.size() > 1 ? fields[1].text : fields[0].text;
    if (title.name == "Y_Unit_Label") {
        for (const CsvField& field : csv_table::split(text, text[mark]))
            header.spoken_units.push_back(field.text);
        header.spoken_units.front().clear();
        return;
    }
    if (title.name.empty() || value.empty()) return;
    if (is_step_key(title.name)) read_spoken_step(header, fields, title.unit);
    if (!is_rate_key(title.name)) {
        header.metadata.emplace_back(title.name, title.unit.empty() ? value : value + " " + title.unit);
        return;
    }
    try {
        const double rate = rate_in(value, title.unit);
        if (is_rate(rate)) header.spoken_rate = rate;
    } catch (const Error&) {
        header.metadata.emplace_back(title.name, value);
    }
}

// "# time [s],force [N]", as numpy.savetxt writes it, and "% Time (s)   Force (N)"; no facts: "# rate: 48000"
std::optional<std::string> names_in_comment(std::string_view line) {
    const std::string_view text = base::trimmed(line.substr(std::min(line.find_first_not_of("#%/! \t"), line.size())));
    if (text.size() == base::trimmed(line).size() || text.find_first_of(":=") != std::string_view::npos)
        return std::nullopt;
    const bool has_delimiter = text.find_first_of("\t;,") != std::string_view::npos;
    const std::vector<CsvField> fields = csv_table::split(text, has_delimiter ? csv_table::sniff(text).delimiter : ' ');
    const auto is_title = [](const CsvField& field) {
        const csv_table::Title title = csv_table::title_of(field.text);
        return csv_table::is_time_name(title.name) || (!title.unit.empty() && is_known_unit(title.unit));
    };
    const bool are_names = fields.size() > 1 && std::any_of(fields.begin(), fields.end(), is_title);
    return are_names ? std::optional(std::string(text)) : std::nullopt;
}

/// The first lines of a file: those of the table, and what stands between them.
struct Beginning {
    std::vector<std::string> texts;  // of the table, and of prose above it
    std::vector<TextLine> lines;     // their numbers and places; the text is in `texts`
    std::vector<std::pair<std::string, TextLine>> comments;

    base::Place place(std::size_t k, const std::string& file) const {
        return place_of(file, {texts[k], lines[k].number, lines[k].offset}, 1);
    }
};

Beginning beginning_of(LineReader& lines) {
    Beginning beginning;
    const auto take = [&](std::string text, const TextLine& line) {
        beginning.texts.push_back(std::move(text));
        beginning.lines.push_back({{}, line.number, line.offset});
    };
    std::optional<std::pair<std::string, TextLine>> names;  // of a comment, if rows of numbers follow
    int headings = 0;                                       // LabVIEW's have two ends; a third is between rows
    for (std::size_t bytes = 0; bytes < most_bytes && beginning.texts.size() < looked_at;) {
        const auto line = lines.next();
        if (!line) break;
        bytes += line->text.size();
        headings += line->text.starts_with(heading_end) ? 1 : 0;
        if (headings > 2) break;
        if (line->text.find_first_not_of(",; \t") == std::string_view::npos) continue;
        if (auto found = names_in_comment(line->text)) {
            names = {*std::move(found), TextLine{{}, line->number, line->offset}};
        } else if (is_table_line(line->text)) {
            const bool is_row = base::trimmed(line->text).find_first_of("+-.0123456789") == 0;
            if (is_row && names) take(names->first, names->second);
            names.reset();
            take(std::string(line->text), *line);
        } else if (base::trimmed(line->text).starts_with('#')) {
            beginning.comments.emplace_back(line->text, TextLine{{}, line->number, line->offset});
        }
    }
    return beginning;
}

// names in the first line, or none; what else cannot be a row of numbers is one of units
csv_table::TableStart plain_start(const Beginning& beginning, const std::string& file) {
    const std::vector<std::string>& texts = beginning.texts;
    const bool has_delimiter = texts[0].find_first_of("\t;,") != std::string::npos;
    csv_table::TableStart start{has_delimiter ? csv_table::sniff(texts[0]) : Dialect{'\0'}, {}, {}, 0, 0, false};
    const auto has_numbers = [&](std::size_t k) {
        return csv_table::is_number_row(csv_table::split(texts[k], start.dialect.delimiter), start.dialect);
    };
    if (has_numbers(0)) return start;
    if (texts.size() > 1 && !has_numbers(1))
        for (const CsvField& field : csv_table::split(texts[1], start.dialect.delimiter))
            if (csv_table::tells_grouping(field.text))
                throw refusal(beginning.place(1, file),
                              "\"" + field.text + "\" may be a decimal number, or one of thousands",
                              "no row tells which mark is the decimal one", "Write the decimal mark as a point.");
    start.names = 0;
    start.rows = 1;
    if (texts.size() > 1 && !has_numbers(1)) {
        start.units = 1;
        start.rows = 2;
    }
    if (texts.size() <= start.rows) throw refusal(beginning.place(0, file), "the table has no row of numbers");
    return start;
}

// "time_ms" is a time in ms, and one in S is no conductance
void part_unit_from_name(SignalColumn& column) {
    if (column.unit == "S" && csv_table::is_time_name(column.name)) column.unit = "s";
    const std::size_t mark = column.name.find_last_of("_ ");
    const bool may_have_one = column.unit.empty() && mark != std::string::npos &&
                              !csv_table::is_time_name(column.name) &&
                              csv_table::is_time_name(std::string_view(column.name).substr(0, mark));
    if (!may_have_one) return;
    column.unit = column.name.substr(mark + 1);
    column.name.resize(mark);
}

// "Start" and "Increment" of an oscilloscope stand beside the names, their values beside the units
void read_facts_beside(TableHeader& header, const std::vector<CsvField>& names, const std::vector<CsvField>& units) {
    for (std::size_t k = 0; k < std::min(names.size(), units.size()); ++k) {
        const bool is_fact = units[k].text != "1" && csv_table::number_in(units[k].text, header.dialect).has_value();
        if (!is_fact) continue;
        header.columns[k].unit.clear();
        header.metadata.emplace_back(names[k].text, units[k].text);
        if (is_step_key(names[k].text)) read_spoken_step(header, {names[k], units[k]}, "");
    }
}

void read_columns(TableHeader& header, const csv_table::TableStart& start, const Beginning& beginning,
                  const base::Place& place) {
    const auto fields_in = [&](std::size_t line) {
        std::vector<CsvField> fields = csv_table::split(beginning.texts[line], start.dialect.delimiter);
        csv_table::drop_empty_tail(fields, 1);
        return fields;
    };
    std::vector<CsvField> fields =
        start.width > 0 ? csv_table::split_names(beginning.texts[start.first()], start.dialect.delimiter, start.width)
                        : fields_in(start.first());
    if (start.width > 0)
        fields.resize(start.width);
    else
        csv_table::drop_comment(fields, fields_in(start.rows).size());
    if (fields.size() > most_columns)
        throw refusal(place, "the table has " + std::to_string(fields.size()) + " columns",
                      "at most " + std::to_string(most_columns) + " are read");
    header.columns.resize(fields.size());
    header.has_names = start.names.has_value();
    if (!header.has_names) return;
    header.names_number = place.line;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        // "tInc = 2.5e-04" stands beside the names
        const std::size_t mark = fields[k].text.find('=');
        if (mark != std::string::npos)
            if (const std::string key(base::trimmed(fields[k].text.substr(0, mark))); is_step_key(key))
                read_spoken_step(header, {{key}, {std::string(base::trimmed(fields[k].text.substr(mark + 1)))}}, "");
        const csv_table::Title title = csv_table::title_of(fields[k].text);
        header.columns[k] = {title.name, std::string(base::trimmed(title.unit)), Role::channel, {}};
        part_unit_from_name(header.columns[k]);
    }
    for (std::size_t k = 0; k < std::min(header.spoken_units.size(), fields.size()); ++k)
        if (header.columns[k].unit.empty()) header.columns[k].unit = header.spoken_units[k];
    if (!start.units) return;
    const std::vector<CsvField> units = fields_in(*start.units);
    for (std::size_t k = 0; k < std::min(units.size(), header.columns.size()); ++k)
        if (const auto unit = base::trimmed(csv_table::bare_unit(units[k].text)); !unit.empty())
            header.columns[k].unit = unit;
    read_facts_beside(header, fields, units);
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
    const bool has_mark = text_at(*input.bytes, 0, 4).starts_with(csv_table::utf8_mark);
    LineReader lines(input.bytes, input.name, has_mark ? csv_table::utf8_mark.size() : 0);
    const Beginning beginning = beginning_of(lines);
    TableHeader header;
    const int end = beginning.lines.empty() ? std::numeric_limits<int>::max() : beginning.lines[0].number;
    for (const auto& [text, line] : beginning.comments)
        if (line.number < end) read_comment(header, {text, line.number, line.offset}, input.name);
    if (beginning.texts.empty())
        throw refusal({input.name, 0, 0, ""}, "the file holds no table", "columns of numbers are expected");
    const std::optional<csv_table::TableStart> found = csv_table::find_start(beginning.texts);
    const csv_table::TableStart start = found ? *found : plain_start(beginning, input.name);
    for (std::size_t k = 0; k < start.first(); ++k) {
        const std::string& text = beginning.texts[k];
        if (text.starts_with(heading_end) && start.names) header.heading.names = beginning.texts[*start.names];
        if (text.starts_with("Delta_X")) header.heading.steps = text;
        read_prose(header, text);
    }
    const std::size_t prose_lines = header.prose_lines;
    // facts may stand left of the first rows
    for (std::size_t k = start.rows; !start.names && k < std::min(beginning.texts.size(), start.rows + 30); ++k)
        if (const auto fields = csv_table::split(beginning.texts[k], start.dialect.delimiter);
            fields.size() > 2 && !fields[0].text.empty() && !csv_table::value_in(fields[0].text, start.dialect))
            read_prose(header, beginning.texts[k]);
    header.prose_lines = prose_lines;
    header.dialect = start.dialect;
    header.has_comment = start.has_comment;
    header.data_offset = beginning.lines[start.rows].offset;
    header.data_number = beginning.lines[start.rows].number;
    read_columns(header, start, beginning, beginning.place(start.first(), input.name));
    return header;
}

}  // namespace stridor::recordings::signal_table
