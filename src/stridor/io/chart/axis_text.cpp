#include "stridor/io/chart/axis_text.hpp"

#include "stridor/advice/design_space.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/case_key.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::io {

sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option) {
    const auto refusal = [&](const std::string& why) {
        return Error(ErrorKind::input, {option + " \"" + text + "\" cannot be read", why,
                                        "For example " + option + " preload=1:40 or " + option + " mu_d=0.2:0.8:30."});
    };
    const std::optional<RangeText> range = split_range(text);
    if (!range || range->parts.size() < 2 || range->parts.size() > 4)
        throw refusal("expected KEY=FROM:TO[:POINTS[:SCALE]]");
    const std::vector<std::string_view>& parts = range->parts;
    const std::string key = advice::quantity_key_called(c, range->key);
    const auto& quantity = std::get<parameters::Quantity>(parameters::field_of(key)->kind);

    sweep::Axis axis{key, 0.0, 1.0, points, sweep::Scale::linear};
    try {
        const RangeEnds ends = read_range_ends(parts[0], parts[1], quantity.unit);
        axis.from = ends.from;
        axis.to = ends.to;
    } catch (const Error& error) {
        throw refusal(error.problem().what + (error.problem().why.empty() ? "" : " (" + error.problem().why + ")"));
    }
    if (!(axis.from < axis.to))
        throw refusal(axis.from > axis.to ? "an axis rises; write the smaller end first"
                                          : "both ends are the same, which makes no axis");
    if (quantity.usual && quantity.usual->scale == sweep::Scale::logarithmic && axis.from > 0.0)
        axis.scale = sweep::Scale::logarithmic;
    if (parts.size() > 2) {
        const std::optional<int> asked = read_points(parts[2], sweep::most_points);
        if (!asked)
            throw refusal("\"" + std::string(parts[2]) + "\" is no number of points from 2 to " +
                          std::to_string(sweep::most_points));
        axis.points = *asked;
    }
    if (parts.size() > 3) {
        const auto* const found = std::find(sweep::scale_names.begin(), sweep::scale_names.end(), parts[3]);
        if (found == sweep::scale_names.end())
            throw refusal("\"" + std::string(parts[3]) + "\" is no scale: linear or log");
        axis.scale = static_cast<sweep::Scale>(found - sweep::scale_names.begin());
    }
    return axis;
}

std::string axis_text(const sweep::Axis& axis) {
    return axis.parameter + "=" + base::shortest(axis.from) + ":" + base::shortest(axis.to) + ":" +
           std::to_string(axis.points) + ":" + std::string(sweep::scale_names[static_cast<std::size_t>(axis.scale)]);
}

}  // namespace stridor::io
