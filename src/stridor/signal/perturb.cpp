#include "stridor/signal/perturb.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/signal/filter.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::signal {

namespace {

// numbers out of a counter (SplitMix64, Steele, Lea, Flood 2014)
std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

// evenly spread in (0, 1)
double share_of(std::uint64_t bits) {
    return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
}

double amplitude_of(double level) {
    return base::power_of_2(level / 6.020599913279624);
}

}  // namespace

Signal with_noise(Signal signal, double ratio, std::uint64_t seed) {
    const auto count = static_cast<double>(signal.samples.size());
    const double mean = std::accumulate(signal.samples.begin(), signal.samples.end(), 0.0) / count;
    double square = 0.0;
    for (const double x : signal.samples)
        square += (x - mean) * (x - mean);
    const double deviation = std::sqrt(square / count) * amplitude_of(-ratio);
    constexpr double two_over_log2_e = 1.3862943611198906;  // 2 ln 2
    std::uint64_t counter = mixed(seed + 0x9e3779b97f4a7c15U);
    for (double& x : signal.samples) {
        // Box and Muller (1958)
        const double radius = std::sqrt(-two_over_log2_e * base::logarithm_2(share_of(mixed(counter))));
        const double turns = share_of(mixed(counter + 0x632be59bd9b4e019U));
        x += deviation * radius * base::sine_cosine_of_turns(turns).cosine;
        counter += 0x9e3779b97f4a7c15U;
    }
    return signal;
}

Signal amplified(Signal signal, double gain) {
    const double factor = amplitude_of(gain);
    for (double& x : signal.samples)
        x *= factor;
    return signal;
}

Signal band_limited(const Signal& signal, double low, double high) {
    Signal result = signal;
    if (low > 0.0) result.samples = filtered(result.samples, high_pass(low, signal.rate));
    if (high > 0.0 && high < 0.5 * signal.rate) result.samples = filtered(result.samples, low_pass(high, signal.rate));
    return result;
}

}  // namespace stridor::signal
