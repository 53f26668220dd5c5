#pragma once

#include "stridor/analysis/friction/slips.hpp"
#include "stridor/analysis/friction/trace.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace stridor::analysis {

/// One run of a rig.
struct FrictionRun {
    std::string name;  // as messages call it: its file
    FrictionMeasurement measurement;
    double velocity = std::numeric_limits<double>::quiet_NaN();  // [m/s] imposed speed, where no channel has it
};

/// Friction at a speed of slip.
struct FrictionPoint {
    std::array<double, 4> speeds{};  // [m/s] of slip, means of the quarters of its time
    double friction = 0.0;           // [1] T/N against the slip
    std::size_t run = 0;
};

/// Returns the mean speed of a point [m/s].
double mean_speed(const FrictionPoint& point);

/// What runs say about friction over the speed of slip.
struct FrictionPoints {
    std::vector<FrictionPoint> points;     // by run, in time order
    std::vector<RecordedSlip> slips;       // of runs with stick-slip whose speed is known, in time order
    MeasuredCoefficient static_friction;   // of the runs' peaks, or first peaks
    MeasuredCoefficient kinetic_friction;  // of runs with stick-slip
    double shortest_block = 0.0;           // [s]
    double longest_block = 0.0;            // [s]
    std::vector<std::string> notes;
};

/// Returns points of friction over the speed of slip, nearly independent of each other.
///
/// Samples of a trace depend on their neighbours. So steady sliding is cut into blocks of ten times the time over which
/// its deviations hang together (the integral of their autocorrelation, up to where it turns negative: Geyer 1992), and
/// a block's mean is one point. A run with stick-slip gives none: the mean of its force is no friction at its speed. It
/// gives Coulomb's two coefficients.
///
/// Throws `Error` (input) where a run's speed is not known, where friction pushes, and what `friction_trace` throws.
FrictionPoints friction_points(std::span<const FrictionRun> runs, const FrictionTraceOptions& options = {});

/// Adds the points of a further run, of this number, to those of others.
void add_run(FrictionPoints& found, const FrictionRun& run, std::size_t number, const FrictionTraceOptions& options);

}  // namespace stridor::analysis
