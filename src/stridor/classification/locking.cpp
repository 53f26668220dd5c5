#include "stridor/classification/locking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::classification {

namespace {

std::string force_text(double force) {
    return std::abs(force) < 1e3 ? fmt::format("{:.3g} N", force) : fmt::format("{:.3g} kN", 1e-3 * force);
}

std::string way_text(double way) {
    return way < 1.0 ? fmt::format("{:.3g} mm", 1e3 * way) : fmt::format("{:.3g} m", way);
}

// ", 62 times the preload of 8 N"
std::string multiple_text(double force, double preload) {
    return fmt::format(", {:.3g} times the preload of {}", force / preload, force_text(preload));
}

bool exceeds(double force, const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    return evidence.preload > 0.0 && force > thresholds.lock_force * evidence.preload;
}

}  // namespace

std::optional<std::string> locking(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    if (!analysis::sticks_for_good(evidence)) return std::nullopt;
    const record::Drag& drag = evidence.ending.outlook.drag;
    const std::string proven = evidence.ending.outlook.future == record::Future::sticks ? " (proven)" : "";
    if (drag.slope > 0.0)
        return fmt::format("locks: N rises from {} to {} over {} and goes on by {}/mm{}", force_text(drag.from),
                           force_text(drag.to), way_text(drag.way), force_text(1e-3 * drag.slope), proven);
    if (exceeds(drag.to, evidence, thresholds))
        return fmt::format("locks: N goes from {} to {} over each stroke of {}{}{}", force_text(drag.from),
                           force_text(drag.to), way_text(drag.way), multiple_text(drag.to, evidence.preload), proven);
    if (exceeds(evidence.largest_force, evidence, thresholds))
        return fmt::format("locks: N reaches {}{}", force_text(evidence.largest_force),
                           multiple_text(evidence.largest_force, evidence.preload));
    return std::nullopt;
}

std::optional<std::string> pressing_warning(const analysis::Evidence& evidence,
                                            const parameters::Thresholds& thresholds) {
    const analysis::Rates& rates = evidence.judged_rates;
    const bool follows_the_way = rates.stick >= thresholds.creak_stick || rates.slip >= thresholds.quiet_slip;
    if (!follows_the_way || !exceeds(evidence.largest_force, evidence, thresholds)) return std::nullopt;
    return fmt::format("N reaches {}{}: the contact digs in (sprag-slip)", force_text(evidence.largest_force),
                       multiple_text(evidence.largest_force, evidence.preload));
}

}  // namespace stridor::classification
