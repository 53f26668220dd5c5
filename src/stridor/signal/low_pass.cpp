#include "stridor/signal/low_pass.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace stridor::signal {

namespace {

// the modified Bessel function of the first kind and order 0, by its power series, which has no cancellation
double bessel_i0(double x) {
    const double quarter_square = 0.25 * x * x;
    double term = 1.0;
    double sum = 1.0;
    for (int k = 1; term > 1e-17 * sum; ++k) {
        term *= quarter_square / (static_cast<double>(k) * k);
        sum += term;
    }
    return sum;
}

// sin(2 pi f n) / (pi n)
double ideal_tap(double cutoff, double n) {
    return n == 0.0 ? 2.0 * cutoff : base::sine_cosine_of_turns(cutoff * n).sine / (std::numbers::pi * n);
}

}  // namespace

std::vector<double> low_pass_taps(const LowPass& design) {
    STRIDOR_EXPECT(0.0 < design.pass && design.pass < design.stop && design.stop <= 0.5);
    STRIDOR_EXPECT(design.attenuation >= 50.0 && design.attenuation <= 180.0);
    const double transition = design.stop - design.pass;
    const double cutoff = 0.5 * (design.pass + design.stop);
    const auto half = static_cast<std::size_t>(std::ceil(0.5 * (design.attenuation - 7.95) / (14.36 * transition))) + 1;
    const double beta = 0.1102 * (design.attenuation - 8.7);
    const double scale = 1.0 / bessel_i0(beta);

    std::vector<double> taps(2 * half + 1);
    double sum = 0.0;
    for (std::size_t k = 0; k <= half; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(half);
        const double window = scale * bessel_i0(beta * std::sqrt(1.0 - share * share));
        const double tap = window * ideal_tap(cutoff, static_cast<double>(k));
        taps[half + k] = taps[half - k] = tap;
        sum += k == 0 ? tap : 2.0 * tap;
    }
    for (double& tap : taps)
        tap /= sum;
    return taps;
}

}  // namespace stridor::signal
