#include "stridor/io/sampled_csv.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace stridor::io {

namespace {

struct Field {
    std::string text;
    int column = 1;  // [1] of its first character
};

struct Line {
    std::string_view text;
    int number = 0;  // [1]
};

/// What the file is written in.
struct Dialect {
    char delimiter = ',';
    bool allows_comma() const { return delimiter != ','; }  // as decimal mark
};

/// One of the two columns.
struct Column {
    std::string_view quantity;  // "time"
    std::string_view unit;      // "s", what it becomes
    std::size_t index = 0;      // where it stands
    std::string given_unit;     // "ms"; empty: SI
};

struct Header {
    Column time{"time", "s", 0, ""};
    Column velocity{"velocity", "m/s", 1, ""};
    std::size_t columns = 2;
    std::size_t lines = 0;  // how many lines of the table it takes
};

base::Place place(const std::string& name, const Line& line, int column) {
    return {name, line.number, column, std::string(line.text)};
}

std::vector<Line> table_lines(std::string_view text) {
    std::vector<Line> lines;
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

Dialect sniff(std::string_view line) {
    for (const char delimiter : {'\t', ';', ','})
        if (line.find(delimiter) != std::string_view::npos) return {delimiter};
    return {};
}

std::vector<Field> split(const Line& line, char delimiter) {
    std::vector<Field> fields(1);
    bool is_quoted = false;
    int column = 0;
    for (const char byte : line.text) {
        // count characters, not bytes: the caret stands under what people see
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
        column += continues ? 0 : 1;
        if (byte == '"') {
            is_quoted = !is_quoted;
        } else if (byte == delimiter && !is_quoted) {
            fields.push_back({"", column + 1});
        } else {
            fields.back().text += byte;
        }
    }
    for (Field& field : fields) {
        const std::size_t blanks = field.text.find_first_not_of(' ');
        field.column += blanks == std::string::npos ? 0 : static_cast<int>(blanks);
        field.text = std::string(base::trimmed(field.text));
    }
    // a delimiter at the end of every line is a habit of some programs
    while (fields.size() > 2 && fields.back().text.empty())
        fields.pop_back();
    return fields;
}

// with a decimal point
std::string numeral(std::string text, Dialect dialect) {
    const bool has_comma = dialect.allows_comma() && text.find('.') == std::string::npos;
    if (has_comma) std::replace(text.begin(), text.end(), ',', '.');
    return text;
}

std::optional<double> number_in(const std::string& field, Dialect dialect) {
    const std::string text = numeral(field, dialect);
    const bool has_plus = text.starts_with('+') && !text.starts_with("+-");
    const char* last = text.data() + text.size();
    double number = 0.0;
    const auto [end, code] = std::from_chars(text.data() + (has_plus ? 1 : 0), last, number);
    if (code == std::errc::invalid_argument || end != last) return std::nullopt;
    return code == std::errc::result_out_of_range ? std::numeric_limits<double>::infinity() : number;
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

/// "velocity [mm/s]" or "velocity (mm/s)" taken apart.
struct Title {
    std::string name;
    std::string unit;
};

Title title_of(const std::string& text) {
    const std::size_t open = text.find_first_of("[(");
    if (open == std::string::npos) return {lower(text), ""};
    const std::size_t close = text.find_first_of("])", open);
    const std::size_t length = close == std::string::npos ? close : close - open - 1;
    return {lower(base::trimmed(std::string_view(text).substr(0, open))), text.substr(open + 1, length)};
}

std::size_t find_column(const std::vector<Field>& fields, const Column& column, const std::string& name,
                        const Line& line) {
    std::string seen;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const std::string title = title_of(fields[k].text).name;
        if (title == column.quantity || title == column.quantity.substr(0, 1)) return k;
        seen += (k == 0 ? "" : ", ") + fields[k].text;
    }
    throw Error(ErrorKind::input,
                {"there is no column " + std::string(column.quantity), "the columns are: " + seen,
                 "Name it \"" + std::string(column.quantity) + " [" + std::string(column.unit) + "]\"."},
                place(name, line, 1));
}

void set_unit(Column& column, std::string_view unit, const base::Place& where) {
    if (base::trimmed(unit).empty()) return;
    try {
        const base::Unit found = base::parse_unit(unit);
        const base::Unit wanted = base::parse_unit(column.unit);
        if (!(found.dimension == wanted.dimension))
            throw Error(ErrorKind::input, {"the column " + std::string(column.quantity) + " is in " +
                                               std::string(unit) + ", " + base::describe(found.dimension),
                                           "expected " + base::describe(wanted.dimension), ""});
        column.given_unit = unit;
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), where);
    }
}

bool is_number_row(const std::vector<Field>& fields, Dialect dialect) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const Field& field) { return number_in(field.text, dialect).has_value(); });
}

void read_units(Header& header, const Line& line, Dialect dialect, const std::string& name) {
    const std::vector<Field> fields = split(line, dialect.delimiter);
    for (Column* column : {&header.time, &header.velocity})
        if (column->index < fields.size()) {
            const Field& field = fields[column->index];
            // "[ms]" and "(ms)" are units too
            std::string_view unit = field.text;
            if (unit.starts_with('[') || unit.starts_with('(')) unit.remove_prefix(1);
            if (unit.ends_with(']') || unit.ends_with(')')) unit.remove_suffix(1);
            set_unit(*column, unit, place(name, line, field.column));
        }
}

Header read_header(const std::vector<Line>& lines, Dialect dialect, const std::string& name) {
    const std::vector<Field> first = split(lines.front(), dialect.delimiter);
    Header header;
    header.columns = first.size();
    if (is_number_row(first, dialect)) {
        if (first.size() == 2) return header;
        throw Error(ErrorKind::input,
                    {std::to_string(first.size()) + " columns without a header", "two are expected: time and velocity",
                     "Name the columns in the first line."},
                    place(name, lines.front(), 1));
    }
    header.lines = 1;
    for (Column* column : {&header.time, &header.velocity}) {
        column->index = find_column(first, *column, name, lines.front());
        const Field& field = first[column->index];
        set_unit(*column, title_of(field.text).unit, place(name, lines.front(), field.column));
    }
    const bool has_units = lines.size() > 1 && !is_number_row(split(lines[1], dialect.delimiter), dialect);
    if (has_units) {
        header.lines = 2;
        read_units(header, lines[1], dialect, name);
    }
    return header;
}

double read_number(const Field& field, const Column& column, Dialect dialect, const base::Place& where) {
    const auto refuse = [&](const std::string& what, const std::string& why, const std::string& suggestion) {
        return Error(ErrorKind::input,
                     {std::string(column.quantity) + " = \"" + field.text + "\" " + what, why, suggestion}, where);
    };
    const std::optional<double> number = number_in(field.text, dialect);
    const bool has_comma = field.text.find(',') != std::string::npos;
    if (!number)
        throw refuse("is not a number", field.text.empty() ? "the field is empty" : "",
                     has_comma ? "Write the decimal mark as a point." : "");
    if (!std::isfinite(*number)) throw refuse("is not a finite number", "", "");
    if (column.given_unit.empty()) return *number;
    try {
        return base::parse_quantity(numeral(field.text, dialect) + " " + column.given_unit, column.unit);
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), where);
    }
}

}  // namespace

SampledMotion read_sampled_csv(std::string_view text, const std::string& name) {
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    if (text.starts_with(utf8_mark)) text.remove_prefix(utf8_mark.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(ErrorKind::input, {"the file is in UTF-16", "", "Save it as UTF-8."}, base::Place{name, 1, 1, ""});
    const std::vector<Line> lines = table_lines(text);
    if (lines.empty())
        throw Error(ErrorKind::input, {"the file holds no table", "a velocity over time is expected", ""},
                    base::Place{name, 0, 0, ""});
    const Dialect dialect = sniff(lines.front().text);
    const Header header = read_header(lines, dialect, name);

    SampledMotion motion;
    for (std::size_t k = header.lines; k < lines.size(); ++k) {
        const Line& line = lines[k];
        const std::vector<Field> fields = split(line, dialect.delimiter);
        if (fields.size() != header.columns)
            throw Error(ErrorKind::input,
                        {"the row has " + std::to_string(fields.size()) + " columns",
                         "the first row has " + std::to_string(header.columns), ""},
                        place(name, line, fields.back().column));
        const auto read = [&](const Column& column) {
            const Field& field = fields[column.index];
            return read_number(field, column, dialect, place(name, line, field.column));
        };
        const double time = read(header.time);
        const bool increases = motion.times.empty() || time > motion.times.back();
        if (!increases)
            throw Error(ErrorKind::input,
                        {"the times do not increase",
                         base::shortest(time) + " s follows " + base::shortest(motion.times.back()) + " s",
                         "Sort the rows by time."},
                        place(name, line, fields[header.time.index].column));
        motion.times.push_back(time);
        motion.velocities.push_back(read(header.velocity));
    }
    return motion;
}

}  // namespace stridor::io
