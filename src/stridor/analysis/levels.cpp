#include "stridor/analysis/levels.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace stridor::analysis {

namespace {

double level(double velocity) {
    if (std::isnan(velocity)) return velocity;
    return velocity > 0.0 ? base::decibels(velocity / reference_velocity) : -std::numeric_limits<double>::infinity();
}

Level level_of(std::span<const record::Vibration> components, double time) {
    double square_time = 0.0;
    double peak_square = 0.0;
    for (const record::Vibration& component : components) {
        square_time += component.square_time;
        peak_square = std::max(peak_square, component.peak_square);
    }
    if (!(time > 0.0)) {
        constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
        return {nothing, nothing, nothing, nothing};
    }
    const double rms = std::sqrt(square_time / time);
    // instants of the largest velocity lie between the sampled ones; a steady velocity is its own peak but for rounding
    const double peak = std::max(rms, std::sqrt(peak_square));
    return {rms, peak, level(rms), level(peak)};
}

}  // namespace

Levels levels(const record::Tally& tally) {
    STRIDOR_EXPECT(tally.vibration.size() == 3);
    const std::span<const record::Vibration> all(tally.vibration);
    return {level_of(all.first(2), tally.vibration_time), level_of(all.subspan(2, 1), tally.vibration_time)};
}

}  // namespace stridor::analysis
