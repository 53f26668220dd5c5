#include "stridor/recordings/table/csv_table.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/table/instants.hpp"
#include "stridor/recordings/table/table_start.hpp"

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
        // "[s]    [N]" are two
        const auto is_bracketed = [](std::string_view text) { return text.starts_with('(') || text.starts_with('['); };
        const bool is_unit = !fields.empty() && is_bracketed(word) && !is_bracketed(fields.back().text);
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

std::vector<CsvField> split_names(std::string_view line, char delimiter, std::size_t width) {
    std::vector<CsvField> fields = split(line, delimiter);
    if (delimiter != ' ' || fields.size() == width) return fields;
    // "Normal Force [N]   Friction Force [N]": at two blanks, then
    std::vector<CsvField> names;
    for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
        const std::size_t end = std::min({line.find("  ", at), line.find('\t', at), line.size()});
        names.push_back({std::string(base::trimmed(line.substr(at, end - at))), static_cast<int>(at) + 1});
        at = line.find_first_not_of(" \t", end);
    }
    return names.size() == width ? names : fields;
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

namespace {

// "1.500" and "12.345.678": groups of three digits behind the first, which is no zero
bool is_grouped(std::string_view text, char mark) {
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    std::size_t digits = std::min(text.find(mark), text.size());
    if (digits == 0 || digits > 3 || digits == text.size() || text.front() == '0') return false;
    for (;;) {
        if (text.substr(0, digits).find_first_not_of(all_digits) != std::string_view::npos) return false;
        if (digits == text.size()) return true;
        text.remove_prefix(digits + 1);
        digits = std::min(text.find(mark), text.size());
        if (digits != 3) return false;
    }
}

// "1'500.25" and "1 500,25": marks that are no decimal ones; Unicode's blanks that do not break and its apostrophe, too
std::string without_clear_marks(std::string text, char delimiter) {
    const auto is_digit = [&](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    for (const std::string_view mark : {"\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99", "\xA0", "'", " "}) {
        if (mark == " " && (delimiter == ' ' || delimiter == '\0')) continue;  // may part numbers
        for (std::size_t at = text.find(mark, 1); at != std::string::npos; at = text.find(mark, at + 1)) {
            const std::size_t behind = at + mark.size();
            const bool is_group = is_digit(at - 1) && is_digit(behind) && is_digit(behind + 1) &&
                                  is_digit(behind + 2) && !is_digit(behind + 3);
            if (is_group) text.erase(at, mark.size());
        }
    }
    return text;
}

// "1.500,25" and "1,500.25": of two marks the last is the decimal one
std::string without_thousands(std::string text) {
    const std::size_t decimal = text.find_last_of(".,");
    if (decimal == std::string::npos) return text;
    const char group = text[decimal] == '.' ? ',' : '.';
    if (is_grouped(std::string_view(text).substr(0, decimal), group)) std::erase(text, group);
    return text;
}

// "2.5D-03", as Fortran prints it
void write_exponent(std::string& text) {
    const std::size_t at = text.find_first_of("dD", 1);
    const bool is_one = at != std::string::npos && at + 2 < text.size() &&
                        (text[at + 1] == '+' || text[at + 1] == '-') && text.find_first_not_of("+-.,0123456789") == at;
    if (is_one) text[at] = 'e';
}

}  // namespace

bool tells_decimal(const CsvField& field, char mark) {
    const std::size_t at = field.text.find_last_of(".,");
    return at != std::string::npos && field.text[at] == mark && !is_grouped(field.text, mark) &&
           number_in(field.text, {';'});
}

bool tells_grouping(const std::string& text) {
    return is_grouped(text, '.') || is_grouped(text, ',');
}

std::string numeral(std::string text, Dialect dialect) {
    text = without_thousands(without_clear_marks(std::move(text), dialect.delimiter));
    write_exponent(text);
    if (dialect.grouping != '\0' && text.find(dialect.grouping) != std::string::npos) {
        if (!is_grouped(text, dialect.grouping)) return "";
        std::erase(text, dialect.grouping);
    }
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

std::optional<double> value_in(const std::string& field, Dialect dialect) {
    const std::optional<double> number = number_in(field, dialect);
    if (number) return number;
    const std::optional<ClockTime> instant = instant_in(field);
    return instant ? std::optional(instant->seconds) : std::nullopt;
}

bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const CsvField& field) { return value_in(field.text, dialect).has_value(); });
}

namespace {

// "Zeit t / s" and "a/(m/s^2)" are quantities over their units (ISO 80000-1), "Zeit in ms" and "Time, s" are as good;
// "rev/min" and "m/s" are units themselves
std::optional<Title> title_with_unit(std::string_view text) {
    for (const std::string_view mark : {" / ", " in ", ", ", "/"}) {
        const std::size_t at = text.find(mark);
        if (at == std::string_view::npos || at == 0) continue;
        const std::string_view name = base::trimmed(text.substr(0, at));
        const std::string_view unit = base::trimmed(text.substr(at + mark.size()));
        if (unit.empty() || !is_known_unit(unit)) continue;
        const bool is_time = is_time_name(name);
        const bool may_be_unit = mark == "/" && !is_time && (is_known_unit(text) || unit_of_label(unit).unit == "s");
        if (!may_be_unit) return Title{std::string(name), std::string(bare_unit(unit))};
    }
    return std::nullopt;
}

}  // namespace

Title title_of(std::string_view text) {
    if (auto title = title_with_unit(text)) return *std::move(title);
    // "gap (front) [m]": what ends the title is its unit
    const std::size_t open = text.ends_with(']') ? text.rfind('[') : text.find_first_of("[(");
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

std::optional<Utf16> utf16_in(std::string_view beginning) {
    if (beginning.starts_with("\xFE\xFF")) return Utf16{2, 0};
    if (beginning.starts_with("\xFF\xFE")) return Utf16{2, 1};
    // without its mark: every second byte is NUL, and the others are text
    for (const std::size_t high : {std::size_t{0}, std::size_t{1}}) {
        std::size_t plain = 0;
        for (std::size_t k = 0; k + 1 < beginning.size(); k += 2) {
            const auto low = static_cast<unsigned char>(beginning[k + 1 - high]);
            const bool is_text = low >= 32 || low == '\n' || low == '\r' || low == '\t';
            plain += beginning[k + high] == '\0' && is_text ? 1 : 0;
        }
        const std::size_t pairs = beginning.size() / 2;
        if (pairs > 8 && 10 * plain > 9 * pairs) return Utf16{0, high};
    }
    return std::nullopt;
}

std::string utf8_of(std::string_view utf16, Utf16 form) {
    const auto unit_at = [&](std::size_t k) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(utf16[k + form.high])) << 8U |
               static_cast<unsigned char>(utf16[k + 1 - form.high]);
    };
    std::string text;
    for (std::size_t k = form.begin; k + 1 < utf16.size(); k += 2) {
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
