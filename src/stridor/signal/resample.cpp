// y(t) = Σ x[n] h(t - n/r),  h(τ) = 2 fc/r sinc(2 fc τ) w(τ): an ideal low-pass at fc under a Kaiser window w of half
// width W (Crochiere and Rabiner 1983). With β = 9 side lobes are 90 dB down and the transition is 11.4 / W wide in 1 / (2π).
#include "stridor/signal/resample.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stridor::signal {

namespace {

constexpr double beta = 9.0;              // [1] of the Kaiser window
constexpr double half_zeros = 60.0;       // [1] zeros of the sinc on either side
constexpr double cutoff_share = 0.475;    // [1] of the lower rate
constexpr std::size_t table_steps = 512;  // per zero

// modified Bessel function of order zero, by its series
double bessel_0(double x) {
    double term = 1.0;
    double sum = 1.0;
    for (double k = 1.0; term > 1e-17 * sum; k += 1.0) {
        const double factor = 0.5 * x / k;
        term *= factor * factor;
        sum += term;
    }
    return sum;
}

// sinc(z) under its window at z = k / table_steps
std::vector<double> kernel_table() {
    const auto count = static_cast<std::size_t>(half_zeros) * table_steps;
    std::vector<double> table(count + 2);
    table[0] = 1.0;
    const double whole = bessel_0(beta);
    for (std::size_t k = 1; k < count; ++k) {
        const double z = static_cast<double>(k) / table_steps;
        const double share = z / half_zeros;
        constexpr double pi = 3.14159265358979323846;
        table[k] = base::sine_cosine_of_turns(0.5 * z).sine / (pi * z) *
                   bessel_0(beta * std::sqrt(1.0 - share * share)) / whole;
    }
    return table;
}

}  // namespace

Signal resampled(const Signal& signal, double rate) {
    if (!(rate > 0.0 && std::isfinite(rate)))
        throw Error(ErrorKind::input, {"a rate of " + base::shortest(rate) + " Hz is none", "it must be positive", ""});
    static const std::vector<double> table = kernel_table();
    const double cutoff = cutoff_share * std::min(rate, signal.rate);  // [Hz]
    const double scale = 2.0 * cutoff / signal.rate;                   // zeros per old sample
    const double reach = half_zeros / scale;                           // [old samples]
    const auto old_count = static_cast<double>(signal.samples.size());
    const auto count = static_cast<std::size_t>(std::floor(old_count * rate / signal.rate + 0.5));
    Signal result{rate, signal.unit, std::vector<double>(count)};
    for (std::size_t m = 0; m < count; ++m) {
        const double centre = static_cast<double>(m) * signal.rate / rate;
        const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(centre - reach)));
        const auto last = static_cast<std::size_t>(std::min(old_count - 1.0, std::floor(centre + reach)));
        double sum = 0.0;
        for (std::size_t n = first; n <= last; ++n) {
            const double place = std::abs(static_cast<double>(n) - centre) * scale * table_steps;
            const auto slot = static_cast<std::size_t>(place);
            if (slot + 1 >= table.size()) continue;
            const double share = place - static_cast<double>(slot);
            sum += signal.samples[n] * ((1.0 - share) * table[slot] + share * table[slot + 1]);
        }
        result.samples[m] = scale * sum;
    }
    return result;
}

}  // namespace stridor::signal
