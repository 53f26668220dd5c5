#include "stability_scan.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/field_name.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::app {

namespace {

Error bad_range(const std::string& over) {
    return {ErrorKind::input,
            {"\"" + over + "\" is no range", "expected KEY=FROM:TO or KEY=FROM:TO:POINTS",
             "For example contact.kinetic_friction=0:0.8:161."}};
}

Error bad_points(const std::string& text) {
    return {ErrorKind::input,
            {"\"" + text + "\" is no number of points",
             "a whole number from 2 to " + std::to_string(analysis::most_scan_points), ""}};
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
    const parameters::Field& field = parameters::quantity_named(base::trimmed(over.substr(0, equals)));
    range.key = parameters::key_of(field);
    range.from = base::parse_quantity(parts[0], parameters::unit_of(field));
    range.to = base::parse_quantity(parts[1], parameters::unit_of(field));
    if (parts.size() == 3) {
        const std::string& text = parts[2];
        const auto result = std::from_chars(text.data(), text.data() + text.size(), range.points);
        const bool is_whole = result.ec == std::errc{} && result.ptr == text.data() + text.size();
        if (!is_whole || range.points < 2 || range.points > analysis::most_scan_points) throw bad_points(text);
    }
    return range;
}

}  // namespace

analysis::StabilityScan scan_stability(const parameters::Case& c, const std::string& over) {
    if (over.empty()) return analysis::scan_stability(c, std::nullopt);
    try {
        return analysis::scan_stability(c, parse_range(over));
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{"--over", 0, 0, over});
    }
}

}  // namespace stridor::app
