#pragma once

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/parameters/case.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stridor::analysis {

/// Stability of sliding at one value of a parameter.
struct StabilityPoint {
    double value = 0.0;  // in the parameter's unit
    SlidingStability stability;
    std::optional<double> critical_velocity{};  // [m/s] as in `DirectionScan`, of a structure of few rows
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

/// Returns the stability along a parameter, with each change of kind between neighbouring points bisected.
///
/// Two changes between the same two points are missed: use more points. `at` gives the stability for a value.
StabilityPath stability_path(const std::function<SlidingStability(double)>& at, double from, double to, int points);

/// Most points of a scan.
inline constexpr int most_scan_points = 100000;

/// The quantity along which stability is followed.
struct ScanRange {
    std::string key;    // "contact.kinetic_friction"
    double from = 0.0;  // in the quantity's unit
    double to = 0.0;    // in the quantity's unit, above `from`
    int points = 41;    // [1] from 2 to `most_scan_points`
};

/// Stability of steady sliding in one direction: of the case, and along a parameter if one was followed.
struct DirectionScan {
    parameters::Direction direction = parameters::Direction::going;
    SlidingStability here;
    StabilityPath path;  // empty without a parameter
    // [m/s] below it sliding is lost, of friction that changes with the slip velocity: `critical_velocity`
    std::optional<double> critical_velocity{};
    std::optional<SlidingModes> modes{};  // of the case, if they were asked for
};

/// Stability of a case.
struct StabilityScan {
    parameters::Case base;
    std::string key;   // the parameter that was followed, "contact.kinetic_friction"; empty: none
    std::string unit;  // its unit
    std::vector<DirectionScan> directions;
};

/// Returns the stability of steady sliding of a case in both directions, and along a quantity if one is given.
///
/// Static friction plays no part in it, so mu_d may exceed mu_s. Throws `Error` (input) if the key is not a quantity,
/// if the ends lie outside its range or do not rise, and if there are too few or too many points.
StabilityScan scan_stability(const parameters::Case& c, const std::optional<ScanRange>& range);

/// Returns the scan with the modes of the case (`sliding_modes`) added for each direction, except one in which it
/// locks.
StabilityScan with_modes(StabilityScan scan);

}  // namespace stridor::analysis
