#include "stridor/io/axis_text.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/sweep/design_space.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

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

bool read_points(std::string_view text, int& points) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), points);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size() && points >= 2 &&
           points <= sweep::most_points;
}

}  // namespace

sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option) {
    const auto refusal = [&](const std::string& why) {
        return Error(ErrorKind::input, {option + " \"" + text + "\" cannot be read", why,
                                        "For example " + option + " preload=1:40 or " + option + " mu_d=0.2:0.8:30."});
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw refusal("expected KEY=FROM:TO[:POINTS[:SCALE]]");
    const std::vector<std::string_view> parts = split(std::string_view(text).substr(equals + 1), ':');
    if (parts.size() < 2 || parts.size() > 4) throw refusal("expected KEY=FROM:TO[:POINTS[:SCALE]]");
    const auto& field = sweep::quantity_named(c, base::trimmed(std::string_view(text).substr(0, equals)));
    const auto& quantity = std::get<parameters::Quantity>(field.kind);

    sweep::Axis axis{parameters::key_of(field), 0.0, 1.0, points, sweep::Scale::linear};
    std::string from(parts[0]);
    if (unit_behind(from).empty()) from += " " + std::string(unit_behind(parts[1]));
    try {
        axis.from = base::parse_quantity(base::trimmed(from), quantity.unit);
        axis.to = base::parse_quantity(parts[1], quantity.unit);
    } catch (const Error& error) {
        throw refusal(error.problem().what + (error.problem().why.empty() ? "" : " (" + error.problem().why + ")"));
    }
    if (!(axis.from < axis.to))
        throw refusal(axis.from > axis.to ? "an axis rises; write the smaller end first"
                                          : "both ends are the same, which makes no axis");
    if (quantity.usual && quantity.usual->scale == sweep::Scale::logarithmic && axis.from > 0.0)
        axis.scale = sweep::Scale::logarithmic;
    if (parts.size() > 2 && !read_points(parts[2], axis.points))
        throw refusal("\"" + std::string(parts[2]) + "\" is no number of points from 2 to " +
                      std::to_string(sweep::most_points));
    if (parts.size() > 3) {
        const auto* const found = std::find(sweep::scale_names.begin(), sweep::scale_names.end(), parts[3]);
        if (found == sweep::scale_names.end())
            throw refusal("\"" + std::string(parts[3]) + "\" is no scale: linear or log");
        axis.scale = static_cast<sweep::Scale>(found - sweep::scale_names.begin());
    }
    return axis;
}

}  // namespace stridor::io
