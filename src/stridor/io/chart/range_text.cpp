#include "stridor/io/chart/range_text.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace stridor::io {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        parts.push_back(base::trimmed(text.substr(start, end - start)));
        start = end + 1;
    }
    return parts;
}

// what stands behind the number: "N" of "40 N"
std::string_view unit_behind(std::string_view text) {
    double number = 0.0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto read = std::from_chars(begin, text.data() + text.size(), number);
    if (read.ec != std::errc{}) return {};
    return base::trimmed(text.substr(static_cast<std::size_t>(read.ptr - text.data())));
}

}  // namespace

std::optional<RangeText> split_range(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    return RangeText{base::trimmed(text.substr(0, equals)), split(text.substr(equals + 1), ':')};
}

RangeEnds read_range_ends(std::string_view from, std::string_view to, std::string_view unit) {
    std::string first(from);
    if (unit_behind(first).empty()) first += " " + std::string(unit_behind(to));
    return {base::parse_quantity(base::trimmed(first), unit), base::parse_quantity(to, unit)};
}

std::optional<int> read_points(std::string_view text, int most) {
    int points = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), points);
    const bool is_whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return is_whole && points >= 2 && points <= most ? std::optional(points) : std::nullopt;
}

}  // namespace stridor::io
