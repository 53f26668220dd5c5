#include "stridor/recordings/table/csv_table.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

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

std::vector<CsvField> split(std::string_view line, char delimiter) {
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
    // from_chars does not say whether a number was too large or too small
    return code == std::errc::result_out_of_range ? std::strtod(text.c_str(), nullptr) : number;
}

bool is_number_row(const std::vector<CsvField>& fields, Dialect dialect) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const CsvField& field) { return number_in(field.text, dialect).has_value(); });
}

Title title_of(std::string_view text) {
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

bool is_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

}  // namespace stridor::recordings::csv_table
