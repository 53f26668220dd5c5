#include "stridor/base/decibels.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/logarithm_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stridor::base {

namespace {

constexpr double decibels_per_doubling = 3.0102999566398119521374;  // 10 log10(2)
constexpr double furthest = 3000.0;                                 // [dB]

[[maybe_unused]] bool have_logarithms(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isnormal(x) && x > 0.0; });
}

}  // namespace

double decibels_of_power(double ratio) {
    if (ratio == 0.0) return -std::numeric_limits<double>::infinity();
    if (ratio < 0.0) return std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(ratio)) return ratio;
    return decibels_per_doubling * logarithm_2(ratio);
}

STRIDOR_CLONES void make_decibels(std::span<double> ratios) {
    STRIDOR_EXPECT(have_logarithms(ratios));
    double* __restrict values = ratios.data();
    for (std::size_t k = 0; k < ratios.size(); ++k)
        values[k] = decibels_per_doubling * logarithm_2_of_normal(values[k]);
}

double power_of_decibels(double level) {
    if (level < -furthest) return 0.0;
    return power_of_2((level < furthest ? level : furthest) / decibels_per_doubling);
}

STRIDOR_CLONES void find_logarithms_2(std::span<const double> values, std::span<double> result) {
    STRIDOR_EXPECT(values.size() == result.size());
    STRIDOR_EXPECT(have_logarithms(values));
    const double* __restrict from = values.data();
    double* __restrict to = result.data();
    for (std::size_t k = 0; k < values.size(); ++k)
        to[k] = logarithm_2_of_normal(from[k]);
}

}  // namespace stridor::base
