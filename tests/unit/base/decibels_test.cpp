#include "stridor/base/decibels.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/logarithm_series.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace stridor::base {
namespace {

using support::signed_fraction;
using support::whole_between;

std::uint64_t bits_of(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

double any_normal() {
    const double mantissa = 1.5 + 0.5 * *signed_fraction();
    return std::ldexp(mantissa, *whole_between(-1020, 1020));
}

RC_GTEST_PROP(Decibels, OfAPowerAreAccurate, ()) {
    const double ratio = any_normal();
    const long double exact = 10.0L * std::log10(static_cast<long double>(ratio));
    RC_PRE(exact != 0.0L);
    // the logarithm's 1e-15 and one rounding
    RC_ASSERT(std::abs((decibels_of_power(ratio) - exact) / exact) < 1.2e-15L);
}

TEST(Decibels, OfNothingAndOfTooMuchAreInfinite) {
    EXPECT_EQ(decibels_of_power(1.0), 0.0);
    EXPECT_EQ(decibels_of_power(0.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(decibels_of_power(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(decibels_of_power(-1.0)));
    EXPECT_TRUE(std::isnan(decibels_of_power(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_NEAR(decibels_of_power(5e-324), -3233.06, 0.01);  // the smallest number above 0
}

RC_GTEST_PROP(Decibels, LeadBackToThePower, ()) {
    const double level = 2900.0 * *signed_fraction();
    // d level = 4.34 d ratio / ratio; the level has 53 bits, the ratio the error told
    RC_ASSERT(std::abs(decibels_of_power(power_of_decibels(level)) - level) <
              4.35 * (1e-15 * (1.0 + std::abs(level) / 3.0)) + 1e-15 * std::abs(level));
}

TEST(Decibels, BeyondThreeThousandHaveAPower) {
    EXPECT_EQ(power_of_decibels(0.0), 1.0);
    EXPECT_NEAR(power_of_decibels(-20.0), 0.01, 1e-16);
    EXPECT_EQ(power_of_decibels(-4000.0), 0.0);
    EXPECT_EQ(power_of_decibels(4000.0), power_of_decibels(3000.0));
}

// the loops are wide, and have ends that are not
TEST(Decibels, OfManyAreThoseOfEachBitForBit) {
    for (std::size_t size = 0; size < 40; ++size) {
        std::vector<double> ratios;
        for (std::size_t k = 0; k < size; ++k)
            ratios.push_back(std::ldexp(1.0 + 0.017 * static_cast<double>(k), static_cast<int>(53 * k) - 1000));
        std::vector<double> octaves(size);
        find_logarithms_2(ratios, octaves);
        std::vector<double> levels = ratios;
        make_decibels(levels);
        for (std::size_t k = 0; k < size; ++k) {
            EXPECT_EQ(bits_of(levels[k]), bits_of(decibels_of_power(ratios[k]))) << ratios[k];
            EXPECT_EQ(bits_of(octaves[k]), bits_of(logarithm_2(ratios[k]))) << ratios[k];
        }
    }
}

RC_GTEST_PROP(LogarithmSeries, IsTheLogarithmOfNormalNumbers, ()) {
    const double x = any_normal();
    RC_ASSERT(bits_of(logarithm_2_of_normal(x)) == bits_of(logarithm_2(x)));
}

TEST(LogarithmSeries, LeavesTheSmallestNumbersToTheLogarithm) {
    for (int exponent = -1074; exponent < -1021; ++exponent)
        EXPECT_EQ(logarithm_2(std::ldexp(1.0, exponent)), exponent);
}

}  // namespace
}  // namespace stridor::base
