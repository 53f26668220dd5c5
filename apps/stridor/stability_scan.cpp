#include "stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/parameters/field.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::app {

namespace {

Error bad_range(const std::string& over) {
    return {ErrorKind::input,
            {"--over \"" + over + "\" cannot be read", "expected KEY=FROM:TO or KEY=FROM:TO:POINTS",
             "For example contact.kinetic_friction=0:0.8:161."}};
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char letter : text)
        if (letter == separator)
            parts.emplace_back();
        else
            parts.back() += letter;
    return parts;
}

analysis::ScanRange parse_range(const std::string& over) {
    const std::size_t equals = over.find('=');
    if (equals == std::string::npos) throw bad_range(over);
    const std::vector<std::string> parts = split(over.substr(equals + 1), ':');
    if (parts.size() < 2 || parts.size() > 3) throw bad_range(over);
    analysis::ScanRange range;
    range.key = over.substr(0, equals);
    range.from = base::parse_quantity(parts[0], parameters::unit_of(range.key));
    range.to = base::parse_quantity(parts[1], parameters::unit_of(range.key));
    if (parts.size() == 3) {
        const std::string& text = parts[2];
        const auto result = std::from_chars(text.data(), text.data() + text.size(), range.points);
        const bool is_whole = result.ec == std::errc{} && result.ptr == text.data() + text.size();
        if (!is_whole || range.points < 2 || range.points > analysis::most_scan_points) throw bad_range(over);
    }
    if (!(range.from < range.to)) throw bad_range(over);
    return range;
}

}  // namespace

analysis::StabilityScan scan_stability(const parameters::Case& c, const std::string& over) {
    return analysis::scan_stability(c, over.empty() ? std::nullopt : std::optional(parse_range(over)));
}

}  // namespace stridor::app
