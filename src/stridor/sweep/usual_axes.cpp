#include "stridor/sweep/usual_axes.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/usual_range.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace stridor::sweep {

Axis usual_axis(const parameters::Case& c, std::string_view key, int points) {
    const std::optional<parameters::UsualRange> range = parameters::usual_range(c, key);
    STRIDOR_EXPECT(range.has_value());
    Axis axis{std::string(key), range->from, range->to, points, range->scale};
    if (key == "contact.kinetic_friction") axis.to = c.contact.static_friction;
    if (axis.to < 0.0) axis = {axis.parameter, -axis.to, -axis.from, points, axis.scale};
    return axis;
}

std::pair<Axis, Axis> usual_axes(const parameters::Case& c, int points) {
    constexpr std::array<std::string_view, 7> wanted{
        "contact.preload", "structure.stiffness_scale", "contact.kinetic_friction", "temperature.value",
        "drive.velocity",  "structure.damping_scale",   "joint.incidence_angle"};
    std::vector<Axis> axes;
    for (const std::string_view key : wanted) {
        const bool is_taken = key == "structure.stiffness_scale" && !axes.empty();
        const bool has_width = key != "contact.kinetic_friction" || c.contact.static_friction > 0.0;
        if (axes.size() < 2 && !is_taken && has_width && parameters::usual_range(c, key))
            axes.push_back(usual_axis(c, key, points));
    }
    // a joint has a preload and an angle, an own structure both scales or a preload in place of one
    return {axes[0], axes[1]};
}

}  // namespace stridor::sweep
