#include "stridor/recordings/table/sampled_csv.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace stridor::recordings {

namespace {

using csv_table::CsvField;
using csv_table::Dialect;

/// One of the two columns.
struct SampleColumn {
    std::string_view quantity;  // "time"
    std::string_view unit;      // "s", what it becomes
    std::size_t index = 0;      // where it stands
    std::string given_unit;     // "ms"; empty: SI
};

struct SampleHeader {
    SampleColumn time{"time", "s", 0, ""};
    SampleColumn velocity{"velocity", "m/s", 1, ""};
    std::size_t columns = 2;
    std::size_t lines = 0;  // how many lines of the table it takes
};

std::vector<TextLine> table_lines(std::string_view text) {
    std::vector<TextLine> lines;
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        const std::string_view line = text.substr(0, end);
        ++number;
        const std::string_view content = base::trimmed(line);
        if (!content.empty() && content.front() != '#') lines.push_back({line, number});
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
    }
    return lines;
}

std::vector<CsvField> split(const TextLine& line, Dialect dialect) {
    std::vector<CsvField> fields = csv_table::split(line.text, dialect.delimiter);
    csv_table::drop_empty_tail(fields, 2);
    return fields;
}

std::size_t find_column(const std::vector<CsvField>& fields, const SampleColumn& column, const std::string& name,
                        const TextLine& line) {
    std::string seen;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const std::string title = csv_table::lower(csv_table::title_of(fields[k].text).name);
        if (title == column.quantity || title == column.quantity.substr(0, 1)) return k;
        seen += (k == 0 ? "" : ", ") + fields[k].text;
    }
    throw Error(ErrorKind::input,
                {"there is no column " + std::string(column.quantity), "the columns are: " + seen,
                 "Name it \"" + std::string(column.quantity) + " [" + std::string(column.unit) + "]\"."},
                place_of(name, line, 1));
}

void set_unit(SampleColumn& column, std::string_view unit, const base::Place& where) {
    if (base::trimmed(unit).empty()) return;
    try {
        const std::string spelt = unit_as_written(unit);
        const base::Unit found = base::parse_unit(spelt);
        const base::Unit wanted = base::parse_unit(column.unit);
        if (!(found.dimension == wanted.dimension))
            throw Error(ErrorKind::input, {"the column " + std::string(column.quantity) + " is in " +
                                               std::string(unit) + ", " + base::describe(found.dimension),
                                           "expected " + base::describe(wanted.dimension), ""});
        column.given_unit = spelt;
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), where);
    }
}

void read_units(SampleHeader& header, const TextLine& line, Dialect dialect, const std::string& name) {
    const std::vector<CsvField> fields = split(line, dialect);
    for (SampleColumn* column : {&header.time, &header.velocity})
        if (column->index < fields.size()) {
            const CsvField& field = fields[column->index];
            set_unit(*column, csv_table::bare_unit(field.text), place_of(name, line, field.column));
        }
}

SampleHeader read_header(const std::vector<TextLine>& lines, Dialect dialect, const std::string& name) {
    const std::vector<CsvField> first = split(lines.front(), dialect);
    SampleHeader header;
    header.columns = first.size();
    if (csv_table::is_number_row(first, dialect)) {
        if (first.size() == 2) return header;
        throw Error(ErrorKind::input,
                    {std::to_string(first.size()) + " columns without a header", "two are expected: time and velocity",
                     "Name the columns in the first line."},
                    place_of(name, lines.front(), 1));
    }
    header.lines = 1;
    for (SampleColumn* column : {&header.time, &header.velocity}) {
        column->index = find_column(first, *column, name, lines.front());
        const CsvField& field = first[column->index];
        set_unit(*column, csv_table::title_of(field.text).unit, place_of(name, lines.front(), field.column));
    }
    const bool has_units = lines.size() > 1 && !csv_table::is_number_row(split(lines[1], dialect), dialect);
    if (has_units) {
        header.lines = 2;
        read_units(header, lines[1], dialect, name);
    }
    return header;
}

double read_number(const CsvField& field, const SampleColumn& column, Dialect dialect, const base::Place& where) {
    const auto refuse = [&](const std::string& what, const std::string& why, const std::string& suggestion) {
        return Error(ErrorKind::input,
                     {std::string(column.quantity) + " = \"" + field.text + "\" " + what, why, suggestion}, where);
    };
    const std::optional<double> number = csv_table::number_in(field.text, dialect);
    const bool has_comma = field.text.find(',') != std::string::npos;
    if (!number)
        throw refuse("is not a number", field.text.empty() ? "the field is empty" : "",
                     has_comma ? "Write the decimal mark as a point." : "");
    if (!std::isfinite(*number)) throw refuse("is not a finite number", "", "");
    if (column.given_unit.empty()) return *number;
    try {
        return base::parse_quantity(csv_table::numeral(field.text, dialect) + " " + column.given_unit, column.unit);
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), where);
    }
}

}  // namespace

SampledMotion read_sampled_csv(std::string_view text, const std::string& name) {
    if (text.starts_with(csv_table::utf8_mark)) text.remove_prefix(csv_table::utf8_mark.size());
    if (csv_table::utf16_in(text.substr(0, 4096)))
        throw Error(ErrorKind::input, {"the file is in UTF-16", "", "Save it as UTF-8."}, base::Place{name, 1, 1, ""});
    const std::vector<TextLine> lines = table_lines(text);
    if (lines.empty())
        throw Error(ErrorKind::input, {"the file holds no table", "a velocity over time is expected", ""},
                    base::Place{name, 0, 0, ""});
    const Dialect dialect = csv_table::sniff(lines.front().text);
    const SampleHeader header = read_header(lines, dialect, name);

    SampledMotion motion;
    for (std::size_t k = header.lines; k < lines.size(); ++k) {
        const TextLine& line = lines[k];
        const std::vector<CsvField> fields = split(line, dialect);
        if (fields.size() != header.columns)
            throw Error(ErrorKind::input,
                        {"the row has " + std::to_string(fields.size()) + " columns",
                         "the first row has " + std::to_string(header.columns), ""},
                        place_of(name, line, fields.back().column));
        const auto read = [&](const SampleColumn& column) {
            const CsvField& field = fields[column.index];
            return read_number(field, column, dialect, place_of(name, line, field.column));
        };
        const double time = read(header.time);
        const bool increases = motion.times.empty() || time > motion.times.back();
        if (!increases)
            throw Error(ErrorKind::input,
                        {"the times do not increase",
                         base::shortest(time) + " s follows " + base::shortest(motion.times.back()) + " s",
                         "Sort the rows by time."},
                        place_of(name, line, fields[header.time.index].column));
        motion.times.push_back(time);
        motion.velocities.push_back(read(header.velocity));
    }
    return motion;
}

SampledMotion read_sampled_file(const std::string& path) {
    constexpr std::uint64_t largest = 1U << 28U;  // [B]
    const auto bytes = open_plain_bytes(path);
    if (bytes->size() > largest)
        throw Error(ErrorKind::input,
                    {"\"" + path + "\" is too large for an imposed motion",
                     "it has " + std::to_string(bytes->size()) + " bytes; at most 256 MiB are read", ""});
    return read_sampled_csv(text_at(*bytes, 0, largest), path);
}

}  // namespace stridor::recordings
