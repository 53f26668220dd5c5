#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::analysis {

/// A fall from a peak to the next valley, as numbers of samples.
struct Fall {
    std::size_t rise_from = 0;  // the valley before, or the beginning
    std::size_t peak = 0;       // the highest
    std::size_t onset = 0;      // the last high one
    std::size_t valley = 0;     // the lowest
};

/// The limits that decide which fall counts.
struct FallLimits {
    double threshold = 0.0;   // [unit of r] least size
    double noise = 0.0;       // [unit of r] standard deviation
    std::size_t longest = 1;  // [1] samples between 90 and 10 % of the way down
};

/// Returns the sudden falls of r, shape [sample], in order; NaN samples are skipped. A fall is complete once r has
/// risen again by the threshold.
std::vector<Fall> falls(std::span<const double> r, const FallLimits& limits);

/// What a fall shows about the contact that let go.
struct Release {
    double peak = 0.0;        // [unit of r] where it let go
    double resolution = 0.0;  // [unit of r] what r climbs within one sample before
    double kinetic = 0.0;     // [unit of r] mean while it slid
};

/// Returns the release that a fall of r shows, shape [sample], in the unit of r.
///
/// The peak is where the climb before the fall would be half a sample after its onset: a line through the last quarter
/// of the climb gives it, or the last two samples of a short climb. The kinetic value is the mean between peak and
/// valley without both; half their sum if no sample lies between.
Release release_of(const Fall& fall, std::span<const double> r);

}  // namespace stridor::analysis
