#include "stridor/base/escapes.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace stridor::base {

namespace {

// the character a text begins with; what is none has its byte's number
char32_t code_point(std::string_view text) {
    const std::size_t length = utf8_length(text);
    const auto lead = static_cast<unsigned char>(text.front());
    if (length < 2) return lead;
    char32_t code = lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k)
        code = code << 6U | (static_cast<unsigned char>(text[k]) & 0x3FU);
    return code;
}

bool is_control(char32_t code) {
    const bool is_c0_or_c1 = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool is_separator = code == 0x2028 || code == 0x2029;
    const bool is_direction = code == 0x061C || code == 0x200E || code == 0x200F ||
                              (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    return is_c0_or_c1 || is_separator || is_direction;
}

// the character, or the byte that is none, which a text begins with
std::string_view first_of(std::string_view text) {
    return text.substr(0, std::max<std::size_t>(1, utf8_length(text)));
}

// "\u001b": the digits of a number to a base, filled up with zeros
std::string escape(std::string_view opening, unsigned number, int base, std::size_t width) {
    std::array<char, 16> digits{};
    const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), number, base).ptr;
    const std::string text(static_cast<const char*>(digits.data()), end);
    return std::string(opening) + std::string(width - std::min(width, text.size()), '0') + text;
}

// a character inside $'..'
std::string in_dollar_quotes(std::string_view character) {
    if (character == "'" || character == "\\") return "\\" + std::string(character);
    if (utf8_length(character) > 0 && !is_control(code_point(character))) return std::string(character);
    std::string text;
    for (const char byte : character)
        text += escape("\\", static_cast<unsigned char>(byte), 8, 3);
    return text;
}

bool begins_formula(char c) {
    return std::string_view("=+-@\t\r\n").find(c) != std::string_view::npos;
}

bool is_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    if (text.find_first_of("0123456789") == std::string_view::npos) return false;  // "-inf" is a name there
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    return !text.empty() && result.ptr == end && result.ec != std::errc::invalid_argument;
}

// after any number of apostrophes
bool looks_like_formula(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
    const bool is_sign = text == "-" || text == "+";
    return !text.empty() && begins_formula(text.front()) && !is_sign && !is_number(text);
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned lead = byte(0);
    const std::size_t length = lead < 0x80U ? 1 : lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
    if (length == 0 || lead > 0xF4U || length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte(k) & 0xC0U) != 0x80U) return 0;
    const unsigned second = length > 1 ? byte(1) : 0U;
    const bool is_out_of_range = (lead == 0xE0U && second < 0xA0U) || (lead == 0xEDU && second > 0x9FU) ||
                                 (lead == 0xF0U && second < 0x90U) || (lead == 0xF4U && second > 0x8FU);
    return is_out_of_range ? 0 : length;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

bool has_control(std::string_view text) {
    for (; !text.empty(); text.remove_prefix(first_of(text).size()))
        if (is_control(code_point(text))) return true;
    return false;
}

std::string visible(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const std::string_view first = first_of(text);
        const char32_t code = code_point(first);
        if (utf8_length(first) == 0)
            shown += escape("\\x", static_cast<unsigned>(code), 16, 2);
        else if (is_control(code) && code != '\n' && code != '\t')
            shown += escape("\\u", static_cast<unsigned>(code), 16, 4);
        else
            shown += first;
        text.remove_prefix(first.size());
    }
    return shown;
}

std::string shell_word(std::string_view text) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+,:@%=";
    // zsh looks for a program behind a leading =
    const bool is_plain = !text.empty() && text.front() != '=' && text.find_first_not_of(plain) == std::string::npos;
    if (is_plain) return std::string(text);
    const bool needs_escapes = has_control(text) || !is_utf8(text);
    std::string word = needs_escapes ? "$'" : "'";
    while (!text.empty()) {
        const std::string_view first = first_of(text);
        if (needs_escapes)
            word += in_dollar_quotes(first);
        else
            word += first == "'" ? std::string_view("'\\''") : first;
        text.remove_prefix(first.size());
    }
    return word + "'";
}

std::string spreadsheet_text(std::string_view text) {
    return (looks_like_formula(text) ? "'" : "") + std::string(text);
}

std::string spreadsheet_line(std::string_view line) {
    std::string text;
    while (!line.empty()) {
        const std::size_t end = line.find_first_of(",;\t");
        std::string_view piece = line.substr(0, end);
        const std::size_t begin = std::min(piece.find_first_not_of(" \""), piece.size());
        text += piece.substr(0, begin);
        piece.remove_prefix(begin);
        const std::string_view bare = piece.substr(0, piece.find_last_not_of(" \"") + 1);
        text += (looks_like_formula(bare) ? "'" : "") + std::string(piece);
        if (end == std::string_view::npos) break;
        text += line[end];
        line.remove_prefix(end + 1);
    }
    return text;
}

std::string from_spreadsheet_text(std::string_view cell) {
    if (cell.starts_with('\'') && looks_like_formula(cell)) cell.remove_prefix(1);
    return std::string(cell);
}

std::string markup_text(std::string_view text) {
    std::string result;
    for (const char c : text)
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    return result;
}

}  // namespace stridor::base
