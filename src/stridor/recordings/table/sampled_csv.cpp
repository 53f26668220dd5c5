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
#include <utility>

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
    SampleColumn over;  // that rises from row to row
    SampleColumn value;
    std::size_t columns = 2;
    std::size_t lines = 0;  // how many lines of the table it takes
};

const SampleHeader motion_header{{"time", "s", 0, ""}, {"velocity", "m/s", 1, ""}};
const SampleHeader friction_header{{"speed", "m/s", 0, ""}, {"friction", "1", 1, ""}};

const SampleHeader force_header{{"deflection", "m", 0, ""}, {"force", "N", 1, ""}};

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
    for (SampleColumn* column : {&header.over, &header.value})
        if (column->index < fields.size()) {
            const CsvField& field = fields[column->index];
            set_unit(*column, csv_table::bare_unit(field.text), place_of(name, line, field.column));
        }
}

SampleHeader read_header(SampleHeader header, const std::vector<TextLine>& lines, Dialect dialect,
                         const std::string& name) {
    const std::vector<CsvField> first = split(lines.front(), dialect);
    header.columns = first.size();
    if (csv_table::is_number_row(first, dialect)) {
        if (first.size() == 2) return header;
        throw Error(
            ErrorKind::input,
            {std::to_string(first.size()) + " columns without a header",
             "two are expected: " + std::string(header.over.quantity) + " and " + std::string(header.value.quantity),
             "Name the columns in the first line."},
            place_of(name, lines.front(), 1));
    }
    header.lines = 1;
    for (SampleColumn* column : {&header.over, &header.value}) {
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

/// The numbers of the two columns, the first rising.
struct TwoColumns {
    std::vector<double> over;    // shape [row]
    std::vector<double> values;  // shape [row]
};

TwoColumns read_two_columns(const SampleHeader& wanted, std::string_view text, const std::string& name) {
    const std::string quantity(wanted.over.quantity), unit(wanted.over.unit);
    if (text.starts_with(csv_table::utf8_mark)) text.remove_prefix(csv_table::utf8_mark.size());
    if (csv_table::utf16_in(text.substr(0, 4096)))
        throw Error(ErrorKind::input, {"the file is in UTF-16", "", "Save it as UTF-8."}, base::Place{name, 1, 1, ""});
    const std::vector<TextLine> lines = table_lines(text);
    if (lines.empty())
        throw Error(ErrorKind::input,
                    {"the file holds no table",
                     "a " + std::string(wanted.value.quantity) + " over " + quantity + " is expected", ""},
                    base::Place{name, 0, 0, ""});
    const Dialect dialect = csv_table::sniff(lines.front().text);
    const SampleHeader header = read_header(wanted, lines, dialect, name);

    TwoColumns table;
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
        const double over = read(header.over);
        if (!table.over.empty() && !(over > table.over.back()))
            throw Error(
                ErrorKind::input,
                {"the " + quantity + "s do not increase",
                 base::shortest(over) + " " + unit + " follows " + base::shortest(table.over.back()) + " " + unit,
                 "Sort the rows by " + quantity + "."},
                place_of(name, line, fields[header.over.index].column));
        table.over.push_back(over);
        table.values.push_back(read(header.value));
    }
    return table;
}

// the bytes of a file that holds `what`
std::string plain_text(const Bytes& bytes, const std::string& path, const char* what) {
    constexpr std::uint64_t largest = 1U << 28U;  // [B]
    if (bytes.size() > largest)
        throw Error(ErrorKind::input,
                    {"\"" + path + "\" is too large for " + what,
                     "it has " + std::to_string(bytes.size()) + " bytes; at most 256 MiB are read", ""});
    return text_at(bytes, 0, largest);
}

}  // namespace

SampledMotion read_sampled_csv(std::string_view text, const std::string& name) {
    TwoColumns table = read_two_columns(motion_header, text, name);
    return {std::move(table.over), std::move(table.values)};
}

SampledMotion read_sampled_file(const std::string& path) {
    const auto bytes = open_plain_bytes(path);
    return read_sampled_csv(plain_text(*bytes, path, "an imposed motion"), path);
}

SampledFriction read_friction_csv(std::string_view text, const std::string& name) {
    TwoColumns table = read_two_columns(friction_header, text, name);
    return {std::move(table.over), std::move(table.values)};
}

SampledFriction read_friction_file(const std::string& path) {
    const auto bytes = open_plain_bytes(path);
    return read_friction_csv(plain_text(*bytes, path, "a table of friction"), path);
}

SampledForce read_force_file(const std::string& path) {
    const auto bytes = open_plain_bytes(path);
    TwoColumns table = read_two_columns(force_header, plain_text(*bytes, path, "a table of force"), path);
    return {std::move(table.over), std::move(table.values)};
}

}  // namespace stridor::recordings
