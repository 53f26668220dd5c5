#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::analysis {

/// A measured friction force, shape [sample] each, even in time.
struct FrictionMeasurement {
    double rate = 0.0;                       // [Hz] samples per second
    std::span<const double> force;           // [N] friction force, either sign
    std::span<const double> velocity{};      // [m/s] imposed sliding velocity; empty: not measured
    std::span<const double> normal_force{};  // [N] pressing force; empty: the preload all the time
    double preload = 0.0;                    // [N]
};

/// The definitions that a friction trace is read with. The defaults suit tests at some millimetres per second.
struct FrictionTraceOptions {
    double least_drop = 0.05;      // [1] smallest drop, as a share of the friction force's level (its 95th percentile)
    double noise_factor = 8.0;     // [1] and at least this many times the standard deviation of the noise
    double longest_drop = 0.25;    // [s] a fall that takes longer is drift
    double moving_velocity = 0.1;  // [1] share of the velocity's 95th percentile from which the parts move
    double reversal = 0.6;  // [1] without velocity: share of the level that the other sign must reach to be a reversal
    double settling =
        0.2;  // [1] share cut at the beginning of each stretch for the kinetic coefficient of steady sliding
    double open_contact = 0.05;  // [1] share of the preload below which a measured normal force says nothing
};

/// A coefficient with its standard uncertainty; NaN where the trace does not show it.
struct MeasuredCoefficient {
    double value = std::numeric_limits<double>::quiet_NaN();        // [1]
    double uncertainty = std::numeric_limits<double>::quiet_NaN();  // [1] standard uncertainty (k = 1)
    long count = 0;                                                 // [1] number of peaks, slips or stretches
};

/// A sudden fall of the friction force: the contact lets go.
struct ForceDrop {
    double time = 0.0;      // [s] of the last sample before the fall
    double duration = 0.0;  // [s] from there to the lowest value
    double from = 0.0;      // [N] magnitude before
    double to = 0.0;        // [N] the lowest one after; negative where the force has changed its sign
    int direction = 1;      // [1] sign of the friction force that drops
};

/// Where the kinetic coefficient comes from.
enum class KineticSource { none, slips, steady_sliding };
inline constexpr std::array<std::string_view, 3> kinetic_source_names{"none", "slips", "steady sliding"};

/// Figures of one direction, or of both together.
struct FrictionFigures {
    int direction = 0;  // [1] +1, -1; 0: both
    // mean of the peaks before drops; without drops, of the first peak of each stretch
    MeasuredCoefficient static_friction;
    // mean over the slips between 90 and 10 % of the fall; without drops, while sliding steadily
    MeasuredCoefficient kinetic_friction;
    KineticSource source = KineticSource::none;
    double mean_friction = std::numeric_limits<double>::quiet_NaN();  // [1] over all moving time
    double moving_time = 0.0;                                         // [s]
    double distance = std::numeric_limits<double>::quiet_NaN();       // [m] slid, where the velocity is known
    long drops = 0;                                                   // [1]
    double drop_rate = 0.0;                                           // [1/s] drops per moving time
    double mean_drop = std::numeric_limits<double>::quiet_NaN();      // [N]
    double largest_drop = std::numeric_limits<double>::quiet_NaN();   // [N]
    double variation = std::numeric_limits<double>::quiet_NaN();      // [1] of the times between drops; 0: all alike
};

/// The results of a friction trace.
struct FrictionTrace {
    FrictionFigures all;
    std::vector<FrictionFigures> directions;  // +1 before -1, those that occur
    std::vector<ForceDrop> drops;             // in time order
    double noise = 0.0;                       // [N] standard deviation of the noise
    double threshold = 0.0;                   // [1] smallest drop of T/N that counted
    std::vector<std::string> notes;           // what the user should know
};

/// Returns static and kinetic friction coefficients and the force drops of a measured friction force;
/// docs/methods/friction-trace.md.
///
/// Stretches of one direction are found by the velocity or, without it, by the sign of the force. Within them, a fall
/// from a peak to the next valley that exceeds a threshold is a drop. The fall after a reversal is never one. Throws
/// `Error` (input) for numbers that are not finite, channels of unequal length, fewer than 16 samples, a preload that
/// is not positive, and a trace in which nothing moves.
FrictionTrace friction_trace(const FrictionMeasurement& measurement, const FrictionTraceOptions& options = {});

/// Returns the condition of VDA 230-206 (10 or 40 N, 1 or 4 mm/s) that a test meets within 10 %: "VDA 230-206, 10 N, 4
/// mm/s"; empty if it meets none.
std::string vda_condition(double preload, double velocity);

}  // namespace stridor::analysis
