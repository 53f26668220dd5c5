#include "stridor/recordings/table/csv_table.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace stridor::recordings::csv_table {

Dialect sniff(std::string_view line) {
    std::string bare;  // without what is quoted
    bool is_quoted = false;
    for (const char c : line) {
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted) bare += c;
    }
    for (const char delimiter : {'\t', ';', ','})
        if (bare.find(delimiter) != std::string::npos) return {delimiter};
    return {};
}

namespace {

// "Time (s)   Force (N)" has two fields
std::vector<CsvField> split_at_blanks(std::string_view line) {
    std::vector<CsvField> fields;
    for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        const std::string_view word = line.substr(at, end - at);
        const bool is_unit = !fields.empty() && (word.front() == '(' || word.front() == '[');
        if (is_unit)
            fields.back().text += " " + std::string(word);
        else
            fields.push_back({std::string(word), static_cast<int>(at) + 1});
        at = line.find_first_not_of(" \t", end);
    }
    if (fields.empty()) fields.emplace_back();
    return fields;
}

}  // namespace

std::vector<CsvField> split(std::string_view line, char delimiter) {
    if (delimiter == ' ') return split_at_blanks(line);
    std::vector<CsvField> fields(1);
    bool is_quoted = false;
    int column = 0;
    for (const char byte : line) {
        // count characters, not bytes: the caret stands under what people see
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
        column += continues ? 0 : 1;
        if (byte == '"') {
            is_quoted = !is_quoted;
        } else if (byte == delimiter && !is_quoted && delimiter != '\0') {
            fields.push_back({"", column + 1});
        } else {
            fields.back().text += byte;
        }
    }
    for (CsvField& field : fields) {
        const std::size_t blanks = field.text.find_first_not_of(' ');
        field.column += blanks == std::string::npos ? 0 : static_cast<int>(blanks);
        field.text = base::from_spreadsheet_text(base::trimmed(field.text));
    }
    return fields;
}

void drop_empty_tail(std::vector<CsvField>& fields, std::size_t least) {
    while (fields.size() > least && fields.back().text.empty())
        fields.pop_back();
}

std::size_t filled(const std::vector<CsvField>& fields) {
    std::size_t count = fields.size();
    while (count > 0 && fields[count - 1].text.empty())
        --count;
    return count;
}

bool tells_quoted_decimals(const std::vector<CsvField>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](const CsvField& field) {
        const std::size_t comma = field.text.find(',');
        if (comma == std::string::npos || !number_in(field.text, {';'})) return false;
        const std::string_view behind = std::string_view(field.text).substr(comma + 1);
        const std::size_t sign = field.text.find_first_of("0123456789,");
        return behind.size() != 3 || comma - sign > 3 || field.text[sign] == '0' || comma == sign;
    });
}

namespace {

// "1.500,25" and "1,500.25": of two marks the last is the decimal one, and the other parts groups of three digits
std::string without_thousands(std::string text) {
    const std::size_t decimal = text.find_last_of(".,");
    if (decimal == std::string::npos) return text;
    const char group = text[decimal] == '.' ? ',' : '.';
    int digits = 0;
    bool is_grouped = false;
    for (std::size_t k = decimal; k > 0 && text[k - 1] != '+' && text[k - 1] != '-'; --k) {
        const char letter = text[k - 1];
        const bool ends_group = letter == group && digits == 3;
        if (!ends_group && (letter < '0' || letter > '9' || digits == 3)) return text;
        is_grouped = is_grouped || ends_group;
        digits = ends_group ? 0 : digits + 1;
    }
    if (is_grouped && digits > 0) std::erase(text, group);
    return text;
}

}  // namespace

std::string numeral(std::string text, Dialect dialect) {
    text = without_thousands(std::move(text));
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
    // from_chars does not say whether a number was too large or too small
    return code == std::errc::result_out_of_range ? std::strtod(text.c_str(), nullptr) : number;
}

namespace {

// digits alone, moved over in `text` together with the mark behind them
std::optional<int> take_digits(std::string_view& text, std::size_t count, char mark) {
    int number = 0;
    const bool is_there = text.size() >= count;
    if (!is_there) return std::nullopt;
    const auto [end, code] = std::from_chars(text.data(), text.data() + count, number);
    if (code != std::errc{} || end != text.data() + count || number < 0) return std::nullopt;
    text.remove_prefix(count);
    if (mark == '\0') return number;
    if (text.empty() || text.front() != mark) return std::nullopt;
    text.remove_prefix(1);
    return number;
}

// days from 1970 in the Gregorian calendar (Hinnant 2013)
double days_since_1970(int year, int month, int day) {
    year -= month <= 2 ? 1 : 0;
    const int era = year / 400;
    const int year_of_era = year - era * 400;
    const int day_of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    return era * 146097.0 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719468;
}

std::optional<double> clock_in(std::string_view text) {
    const auto hour = take_digits(text, text.size() > 1 && text[1] == ':' ? 1 : 2, ':');
    const auto minute = hour ? take_digits(text, 2, ':') : std::nullopt;
    if (!minute || text.empty() || text.front() < '0' || text.front() > '9') return std::nullopt;
    double second = 0.0;
    std::string numeral(text);
    std::replace(numeral.begin(), numeral.end(), ',', '.');
    const auto [end, code] = std::from_chars(numeral.data(), numeral.data() + numeral.size(), second);
    const std::string_view rest(end, static_cast<std::size_t>(numeral.data() + numeral.size() - end));
    const bool is_whole = code == std::errc{} && (rest.empty() || rest == "Z" || rest == "+00:00");
    return is_whole && second < 61.0 ? std::optional(3600.0 * *hour + 60.0 * *minute + second) : std::nullopt;
}

std::optional<double> instant_in(std::string_view text) {
    if (text.size() < 7 || text.find(':') == std::string_view::npos) return std::nullopt;
    if (const auto clock = clock_in(text)) return clock;
    const auto year = take_digits(text, 4, text.size() > 4 && text[4] == '/' ? '/' : '-');
    const auto month = year ? take_digits(text, 2, text.size() > 2 && text[2] == '/' ? '/' : '-') : std::nullopt;
    const auto day = month ? take_digits(text, 2, text.size() > 2 && text[2] == 'T' ? 'T' : ' ') : std::nullopt;
    const auto clock = day ? clock_in(text) : std::nullopt;
    if (!clock || *month < 1 || *month > 12) return std::nullopt;
    return 86400.0 * days_since_1970(*year, *month, *day) + *clock;
}

}  // namespace

std::optional<double> value_in(const std::string& field, Dialect dialect) {
    const std::optional<double> number = number_in(field, dialect);
    return number ? number : instant_in(field);
}

bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const CsvField& field) { return value_in(field.text, dialect).has_value(); });
}

Title title_of(std::string_view text) {
    // "gap (front) [m]": what ends the title is its unit
    const std::size_t open = text.ends_with(']') ? text.rfind('[') : text.find_first_of("[(");
    // "Zeit t / s" is a quantity over its unit (ISO 80000-1)
    const std::size_t slash = text.rfind(" / ");
    const bool has_quotient = open == std::string_view::npos && slash != std::string_view::npos;
    const std::string_view behind = has_quotient ? text.substr(slash + 3) : "";
    if (!behind.empty() && is_known_unit(behind))
        return {std::string(base::trimmed(text.substr(0, slash))), std::string(behind)};
    if (open == std::string_view::npos) return {std::string(text), ""};
    const std::size_t close = text.find_first_of("])", open);
    const std::size_t length = close == std::string_view::npos ? close : close - open - 1;
    return {std::string(base::trimmed(text.substr(0, open))), std::string(text.substr(open + 1, length))};
}

std::string_view bare_unit(std::string_view text) {
    if (text.starts_with('[') || text.starts_with('(')) text.remove_prefix(1);
    if (text.ends_with(']') || text.ends_with(')')) text.remove_suffix(1);
    return text;
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

bool is_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

std::string utf8_of(std::string_view utf16) {
    const std::size_t high = utf16.starts_with("\xFE\xFF") ? 0 : 1;  // byte of a pair
    const auto unit_at = [&](std::size_t k) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(utf16[k + high])) << 8U |
               static_cast<unsigned char>(utf16[k + 1 - high]);
    };
    std::string text;
    for (std::size_t k = 2; k + 1 < utf16.size(); k += 2) {
        std::uint32_t code = unit_at(k);
        const bool leads = code >= 0xD800U && code < 0xDC00U && k + 3 < utf16.size();
        const std::uint32_t trail = leads ? unit_at(k + 2) : 0;
        if (trail >= 0xDC00U && trail < 0xE000U) {
            code = 0x10000U + ((code - 0xD800U) << 10U) + (trail - 0xDC00U);
            k += 2;
        }
        if (code >= 0xD800U && code < 0xE000U) code = '?';
        const auto push = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
        if (code < 0x80U) {
            push(code);
        } else if (code < 0x800U) {
            push(0xC0U | code >> 6U);
            push(0x80U | (code & 0x3FU));
        } else {
            push(code < 0x10000U ? 0xE0U | code >> 12U : 0xF0U | code >> 18U);
            if (code >= 0x10000U) push(0x80U | (code >> 12U & 0x3FU));
            push(0x80U | (code >> 6U & 0x3FU));
            push(0x80U | (code & 0x3FU));
        }
    }
    return text;
}

}  // namespace stridor::recordings::csv_table
