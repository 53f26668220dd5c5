#pragma once

#include "stridor/analysis/sliding_stability.hpp"

#include <functional>
#include <vector>

namespace stridor::analysis {

/// Stability of sliding at one value of a parameter.
struct StabilityPoint {
    double value = 0.0;  // in the parameter's unit
    SlidingStability stability;
};

/// Where stability changes its kind along a parameter.
struct StabilityBoundary {
    double value = 0.0;  // in the parameter's unit, bisected to 1e-12 of the range
    StabilityKind below = StabilityKind::stable;
    StabilityKind above = StabilityKind::stable;
    double frequency = 0.0;  // [Hz] of the mode with the largest growth there
};

/// Stability of sliding along a parameter.
struct StabilityPath {
    std::vector<StabilityPoint> points;         // evenly spaced, both ends included
    std::vector<StabilityBoundary> boundaries;  // by rising value
};

/// Follows the stability along a parameter and bisects each change of kind between neighbouring points.
///
/// Two changes between the same two points are missed: use more points. `at` gives the stability for a value.
StabilityPath stability_path(const std::function<SlidingStability(double)>& at, double from, double to, int points);

}  // namespace stridor::analysis
