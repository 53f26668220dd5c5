#pragma once

#include <bit>
#include <cstdint>

namespace stridor::base {

/// Returns the logarithm to base 2 of a positive normal number, with the same bits on every machine.
///
/// x = m 2^e with m in [1/sqrt 2, sqrt 2), s = (m-1)/(m+1), ln m = 2 (s + s^3/3 + s^5/5 + ...), |s| < 0.1716, truncated
/// after s^21/21: relative error s^22/23 < 1e-18. It has no branch and no table, so that loops over it become wide.
/// Of other numbers it returns some finite number.
inline double logarithm_2_of_normal(double x) {
    constexpr double two_over_ln_2 = 2.0 / 0.693147180559945309417;
    constexpr auto root_half = std::bit_cast<std::uint64_t>(0.70710678118654752440);
    constexpr std::uint64_t exponent_bits = 0xfff0000000000000U;
    // a whole number below 2^52 is converted as the last bits of 2^52
    constexpr std::uint64_t big_bits = 0x4330000000000000U;
    constexpr double big = 0x1p52 + 1024.0;
    constexpr std::uint64_t bias = std::uint64_t{1024} << 52U;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t above = (bits - root_half) & exponent_bits;
    const double exponent = std::bit_cast<double>(big_bits | ((above + bias) >> 52U)) - big;
    const auto m = std::bit_cast<double>(bits - above);
    const double s = (m - 1.0) / (m + 1.0);
    const double z = s * s;
    double sum = 1.0 / 21.0 * z;
    sum = (sum + 1.0 / 19.0) * z;
    sum = (sum + 1.0 / 17.0) * z;
    sum = (sum + 1.0 / 15.0) * z;
    sum = (sum + 1.0 / 13.0) * z;
    sum = (sum + 1.0 / 11.0) * z;
    sum = (sum + 1.0 / 9.0) * z;
    sum = (sum + 1.0 / 7.0) * z;
    sum = (sum + 1.0 / 5.0) * z;
    sum = (sum + 1.0 / 3.0) * z;
    return exponent + two_over_ln_2 * (s + s * sum);
}

}  // namespace stridor::base
