#include "stridor/base/elementary.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/logarithm_series.hpp"

#include <cmath>
#include <limits>

// Elementary functions with fixed bits.
//
// sine, cosine: with turns = q/4 + r, |r| <= 1/8, and x = 2 pi r, |x| <= pi/4, Taylor series to x^17 and x^18 have a
// truncation error below (pi/4)^19/19! = 8e-20 and (pi/4)^20/20! = 3e-21; q selects and signs the pair.
// power: 2^f = exp(f ln 2), |f| <= 1/2, Taylor to degree 17.
// exponential: x = k ln 2 + f, |f| <= 0.3466, Taylor to degree 14: 0.3466^15/15! < 1e-19.
namespace stridor::base {

namespace {

constexpr double ln_2 = 0.693147180559945309417;
// ln 2 in two parts: the first has 32 trailing zero bits, so that a whole number times it is exact
constexpr double ln_2_high = 0x1.62e42feep-1;
constexpr double ln_2_low = 0x1.a39ef35793c76p-33;
// [rad] of 0/8, 1/8, ..., 8/8
constexpr double arctangents_of_eighths[] = {0.0,
                                             0.12435499454676143503,
                                             0.24497866312686415417,
                                             0.35877067027057222040,
                                             0.46364760900080611621,
                                             0.55859931534356243597,
                                             0.64350110879328438680,
                                             0.71882999962162450542,
                                             0.78539816339744830962};
constexpr double decibels_per_octave = 6.020599913279623904275;  // 20 log10(2)

double sine_series(double x) {
    const double z = x * x;
    double sum = 1.0 / 355687428096000.0;  // 1/17!
    sum = sum * z - 1.0 / 1307674368000.0;
    sum = sum * z + 1.0 / 6227020800.0;
    sum = sum * z - 1.0 / 39916800.0;
    sum = sum * z + 1.0 / 362880.0;
    sum = sum * z - 1.0 / 5040.0;
    sum = sum * z + 1.0 / 120.0;
    sum = sum * z - 1.0 / 6.0;
    return x + x * (z * sum);
}

double cosine_series(double x) {
    const double z = x * x;
    double sum = -1.0 / 6402373705728000.0;  // 1/18!
    sum = sum * z + 1.0 / 20922789888000.0;
    sum = sum * z - 1.0 / 87178291200.0;
    sum = sum * z + 1.0 / 479001600.0;
    sum = sum * z - 1.0 / 3628800.0;
    sum = sum * z + 1.0 / 40320.0;
    sum = sum * z - 1.0 / 720.0;
    sum = sum * z + 1.0 / 24.0;
    return 1.0 - 0.5 * z + z * z * sum;
}

// a remainder in [-1/2, 1/2] quarter turns beside the whole quarters, both exact
SineCosine from_quarters(double quarters) {
    const double whole = std::nearbyint(quarters);
    const double x = (quarters - whole) * (two_pi / 4.0);
    const double s = sine_series(x);
    const double c = cosine_series(x);
    const int quadrant = static_cast<int>(static_cast<long long>(whole) & 3);
    switch (quadrant) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

}  // namespace

SineCosine sine_cosine_of_turns(double turns) {
    STRIDOR_EXPECT(std::abs(turns) < 0x1p51);
    return from_quarters(4.0 * turns);
}

SineCosine sine_cosine_of_degrees(double degrees) {
    STRIDOR_EXPECT(std::abs(degrees) < 0x1p51);
    const double whole = std::nearbyint(degrees / 90.0);
    const double rest = degrees - 90.0 * whole;  // exact: 90 * whole is a small integer, the difference cancels
    const SineCosine small = from_quarters(rest / 90.0);
    switch (static_cast<int>(static_cast<long long>(whole) & 3)) {
        case 0:
            return small;
        case 1:
            return {small.cosine, -small.sine};
        case 2:
            return {-small.sine, -small.cosine};
        default:
            return {-small.cosine, small.sine};
    }
}

double logarithm_2(double x) {
    STRIDOR_EXPECT(x > 0.0);
    if (!std::isfinite(x)) return x;
    return x < std::numeric_limits<double>::min() ? logarithm_2_of_normal(0x1p54 * x) - 54.0 : logarithm_2_of_normal(x);
}

double power_of_2(double x) {
    STRIDOR_EXPECT(std::abs(x) < 1000.0);
    const double whole = std::nearbyint(x);
    const double f = (x - whole) * ln_2;
    double sum = 1.0;
    for (int k = 17; k >= 1; --k)
        sum = 1.0 + sum * f / k;
    return std::ldexp(sum, static_cast<int>(whole));
}

// in the next three what is no number stays none: that a motion has left double precision is for its engine to say
double exponential(double x) {
    STRIDOR_EXPECT(!(x >= 700.0));
    if (std::isnan(x)) return x;
    if (x < -700.0) return 0.0;
    const double whole = std::nearbyint(x / ln_2);
    const double f = (x - whole * ln_2_high) - whole * ln_2_low;
    double sum = 1.0 / 87178291200.0;  // 1/14!
    sum = sum * f + 1.0 / 6227020800.0;
    sum = sum * f + 1.0 / 479001600.0;
    sum = sum * f + 1.0 / 39916800.0;
    sum = sum * f + 1.0 / 3628800.0;
    sum = sum * f + 1.0 / 362880.0;
    sum = sum * f + 1.0 / 40320.0;
    sum = sum * f + 1.0 / 5040.0;
    sum = sum * f + 1.0 / 720.0;
    sum = sum * f + 1.0 / 120.0;
    sum = sum * f + 1.0 / 24.0;
    sum = sum * f + 1.0 / 6.0;
    sum = sum * f + 0.5;
    return std::ldexp(1.0 + (f + f * f * sum), static_cast<int>(whole));
}

double power(double x, double y) {
    STRIDOR_EXPECT(!(x < 0.0) && y >= 0.0);
    if (y == 0.0) return 1.0;
    if (x == 0.0) return 0.0;
    if (y == 1.0 || std::isnan(x)) return x;
    if (y == 2.0) return x * x;
    if (std::isinf(x)) return power_of_2(999.0);
    const double doublings = y * logarithm_2(x);
    if (doublings < -999.0) return 0.0;
    return power_of_2(doublings < 999.0 ? doublings : 999.0);
}

double arctangent(double x) {
    STRIDOR_EXPECT(!(x < 0.0));
    if (std::isnan(x)) return x;
    // near a sixteenth of a right angle its tangent is known: arctan x = that + arctan((x - t)/(1 + x t))
    const bool is_steep = x > 1.0;
    const double flat = is_steep ? 1.0 / x : x;
    const auto step = static_cast<std::size_t>(8.0 * flat + 0.5);
    const double t = 0.125 * static_cast<double>(step);
    const double rest = (flat - t) / (1.0 + flat * t);
    const double z = rest * rest;
    double sum = 0.0;  // the series to rest^17/17; |rest| <= 1/16: it ends below 2e-22
    for (int k = 17; k >= 3; k -= 2)
        sum = (1.0 / k - sum) * z;
    const double angle = arctangents_of_eighths[step] + (rest - rest * sum);
    return is_steep ? (0.25 * two_pi - angle) : angle;
}

double decibels(double ratio) {
    return decibels_per_octave * logarithm_2(ratio);
}

}  // namespace stridor::base
