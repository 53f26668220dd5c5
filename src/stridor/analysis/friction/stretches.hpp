#pragma once

#include "stridor/analysis/friction/trace.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::analysis {

/// Rubber under small loads reaches 5; what lies far beyond is another unit, another preload, or no measurement.
inline constexpr double most_friction = 20.0;  // [1]

/// Samples [from, to) of one direction.
struct ForceStretch {
    std::size_t from = 0;
    std::size_t to = 0;
    int direction = 1;  // [1] +1, -1
};

/// Returns the value below which a share of the values lies; NaN without any.
double quantile(std::vector<double> values, double share);

/// Returns the finite values without their sign.
std::vector<double> magnitudes(std::span<const double> values);

/// Throws `Error` (input) for a measurement that has no figures: see `friction_trace`.
void expect_valid(const FrictionMeasurement& measurement);

/// Returns T/N with its own sign [1], shape [sample]; NaN where the contact is all but open.
std::vector<double> force_ratios(const FrictionMeasurement& measurement, const FrictionTraceOptions& options);

/// Returns the stretches of one direction, in time order, of a trace with the ratios r.
///
/// They are found by the velocity or, without it, by the sign of the force. Throws `Error` (input) if there is none.
std::vector<ForceStretch> force_stretches(const FrictionMeasurement& measurement, std::span<const double> r,
                                          const FrictionTraceOptions& options);

}  // namespace stridor::analysis
