#include "stridor/analysis/levels.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace stridor::analysis {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double level(double velocity) {
    if (std::isnan(velocity)) return velocity;
    return velocity >= reference_velocity ? base::decibels(velocity / reference_velocity)
                                          : -std::numeric_limits<double>::infinity();
}

Level level_of(std::span<const record::Vibration> components, double time) {
    double square_time = 0.0;
    double peak_square = 0.0;
    for (const record::Vibration& component : components) {
        square_time += component.square_time;
        peak_square = std::max(peak_square, component.peak_square);
    }
    if (!(time > 0.0)) {
        return {nothing, nothing, nothing, nothing};
    }
    const double rms = std::sqrt(square_time / time);
    // instants of the largest velocity lie between the sampled ones; a steady velocity is its own peak but for rounding
    const double peak = std::max(rms, std::sqrt(peak_square));
    return {rms, peak, level(rms), level(peak)};
}

}  // namespace

Levels levels(const record::Tally& tally, std::size_t contact, Part part, Along along) {
    const bool is_closing = part == Part::closing;
    const std::span<const record::Vibration> all(is_closing ? tally.closing_vibration : tally.vibration);
    const double time = is_closing ? tally.closing_time : tally.vibration_time;
    const std::size_t points = 2 * tally.contacts.size();
    STRIDOR_EXPECT((all.size() == points || all.size() == points + 1) && contact < tally.contacts.size());
    // an own structure has no plate; across a closed contact it rests
    if (all.size() == points)
        return {level_of(along == Along::carried ? all.subspan(2 * contact + 1, 1) : all.subspan(2 * contact, 2), time),
                {nothing, nothing, nothing, nothing}};
    const Level plate = level_of(all.last(1), time);
    // the gap is closed: across the contact a carried joint moves as the plate does
    return {along == Along::carried ? plate : level_of(all.subspan(2 * contact, 2), time), plate};
}

}  // namespace stridor::analysis
