// r = T/N in the sense of its direction. Within a stretch of one direction r climbs while the contact sticks and falls
// when it lets go. Peaks and valleys are found by hysteresis: a peak is known once r lies a threshold below it, a
// valley once r lies a threshold above it. From each peak to its valley:
//
//     onset      last sample within a tenth of the fall (or the noise) of the peak
//     static     r at the onset, on the line through the samples before it where they are many: noise does not lift it
//     kinetic    mean of r between 90 and 10 % of the way down
//
// A force measured through a spring swings evenly about mu_d N in a slip; the contact's own force is mu_d N: the mean
// of both is the kinetic coefficient.

#include "stridor/analysis/friction/falls.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::analysis {

namespace {

constexpr std::size_t most_line_samples = 64;  // of the line through the end of a climb

// the samples between 90 and 10 % of the way down
struct Descent {
    std::size_t from = 0;  // the last one above
    std::size_t to = 0;    // the first one below
};
Descent descent_of(std::span<const double> r, std::size_t peak, std::size_t valley) {
    const double size = r[peak] - r[valley];
    Descent descent{peak, valley};
    for (std::size_t k = peak; k <= valley; ++k)
        if (r[k] >= r[valley] + 0.9 * size) descent.from = k;
    for (std::size_t k = valley; k > descent.from; --k)
        if (r[k] <= r[valley] + 0.1 * size) descent.to = k;
    return descent;
}

std::size_t onset_of(std::span<const double> r, std::size_t peak, std::size_t valley, double noise) {
    const double least = r[peak] - std::max(0.1 * (r[peak] - r[valley]), 4.0 * noise);
    std::size_t onset = peak;
    for (std::size_t k = peak; k < valley; ++k)
        if (r[k] >= least) onset = k;
    return onset;
}

// r at `last` on the least-squares line through the `count` samples that end there
struct FittedLine {
    double value = 0.0;
    double slope = 0.0;  // per sample
};
FittedLine line_at_end(std::span<const double> r, std::size_t last, std::size_t count) {
    double sum = 0.0, moment = 0.0, n = 0.0, s1 = 0.0, s2 = 0.0;
    for (std::size_t j = 0; j < count; ++j) {
        const double value = r[last - j];
        if (!std::isfinite(value)) continue;
        const auto x = -static_cast<double>(j);
        sum += value;
        moment += x * value;
        n += 1.0;
        s1 += x;
        s2 += x * x;
    }
    const double determinant = n * s2 - s1 * s1;
    if (determinant <= 0.0) return {r[last], 0.0};
    return {(s2 * sum - s1 * moment) / determinant, (n * moment - s1 * sum) / determinant};
}

}  // namespace

std::vector<Fall> falls(std::span<const double> r, const FallLimits& limits) {
    const double threshold = limits.threshold;
    std::vector<Fall> found;
    std::size_t peak = 0, valley = 0, rise_from = 0;
    bool is_falling = false;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (!std::isfinite(r[k])) continue;
        if (!is_falling) {
            if (!(r[k] <= r[peak])) peak = k;
            if (r[k] <= r[peak] - threshold) {
                is_falling = true;
                valley = k;
            }
        } else {
            if (r[k] < r[valley]) valley = k;
            if (r[k] >= r[valley] + threshold) {
                const Descent descent = descent_of(r, peak, valley);
                if (descent.to - descent.from <= limits.longest)
                    found.push_back({rise_from, peak, onset_of(r, peak, valley, limits.noise), valley});
                is_falling = false;
                rise_from = valley;
                peak = k;
            }
        }
    }
    return found;
}

Release release_of(const Fall& fall, std::span<const double> r) {
    Release release;
    // noise asks for many samples, the shape of the climb for few: a quarter of it
    const std::size_t climb = fall.onset - fall.rise_from;
    const std::size_t count = std::clamp<std::size_t>(climb / 4, 1, most_line_samples);
    const FittedLine line = line_at_end(r, fall.onset, count);
    const double climb_rate = count >= 4 ? line.slope : r[fall.onset] - r[std::max<std::size_t>(fall.onset, 1) - 1];
    release.resolution = std::isfinite(climb_rate) ? std::max(0.0, climb_rate) : 0.0;
    // the contact let go somewhere between this sample and the next
    release.peak = (count >= 4 ? line.value : r[fall.onset]) + 0.5 * release.resolution;
    // the peak and the valley are left out alike, so that an even swing is not pulled to either side
    const Descent descent = descent_of(r, fall.peak, fall.valley);
    double sum = 0.0, count_between = 0.0;
    for (std::size_t k = descent.from + 1; k < descent.to; ++k)
        if (std::isfinite(r[k])) {
            sum += r[k];
            count_between += 1.0;
        }
    release.kinetic = count_between > 0.0 ? sum / count_between : 0.5 * (release.peak + r[fall.valley]);
    return release;
}

}  // namespace stridor::analysis
