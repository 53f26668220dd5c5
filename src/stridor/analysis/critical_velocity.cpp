#include "stridor/analysis/critical_velocity.hpp"

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <limits>

namespace stridor::analysis {

namespace {

constexpr int velocities_per_decade = 4;
constexpr int velocity_decades = 9;                            // from `slowest_sought` to `fastest_sought`
constexpr int velocity_halvings = 45;                          // of a quarter of a decade: 2e-14 of it
constexpr double decade_in_octaves = 3.321928094887362347870;  // log2(10)

bool has_changing_friction(const model::Structure& structure) {
    return std::any_of(structure.contacts.begin(), structure.contacts.end(),
                       [](const model::ContactPoint& contact) { return !is_state_wise(contact.friction); });
}

}  // namespace

std::optional<double> critical_velocity(const model::Structure& structure, parameters::Direction direction) {
    if (!has_changing_friction(structure)) return std::nullopt;
    const auto at = [&](double speed) { return sliding_stability(structure, direction, speed); };
    const auto lasts = [](const SlidingStability& stability) { return stability.kind == StabilityKind::stable; };
    double above = fastest_sought;
    SlidingStability stability = at(above);
    if (!lasts(stability)) return std::numeric_limits<double>::infinity();
    // the sign of the growth is sharper than the kind, which grants it some rounding; an undamped mode has no sign
    bool has_sign = stability.growth < 0.0;
    double below = 0.0;
    for (int k = 1; k <= velocities_per_decade * velocity_decades && below == 0.0; ++k) {
        const double octaves = decade_in_octaves * k / velocities_per_decade;
        const double speed = fastest_sought * base::power_of_2(-octaves);
        stability = at(speed);
        if (lasts(stability)) {
            above = speed;
            has_sign = stability.growth < 0.0;
        } else {
            below = speed;
        }
    }
    if (below == 0.0) return 0.0;
    for (int k = 0; k < velocity_halvings; ++k) {
        const double middle = 0.5 * (below + above);
        stability = at(middle);
        const bool is_lost =
            has_sign && stability.kind != StabilityKind::locked ? stability.growth > 0.0 : !lasts(stability);
        (is_lost ? below : above) = middle;
    }
    return 0.5 * (below + above);
}

}  // namespace stridor::analysis
