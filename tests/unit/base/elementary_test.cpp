#include "stridor/base/elementary.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace stridor::base {
namespace {

constexpr long double two_pi = 6.283185307179586476925286766559L;

using support::signed_fraction;
using support::whole_between;

std::uint64_t bits(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

// the oracle: libm in extended precision, error below 1e-19
long double relative_error(double value, long double exact) {
    return std::abs((static_cast<long double>(value) - exact) / exact);
}

static_assert(std::numeric_limits<long double>::digits >= 64, "the oracle needs more than double precision");

RC_GTEST_PROP(SineCosine, OfTurnsIsExactToTwoTimesTenToTheMinusSixteen, ()) {
    const double turns = 3.0 * *signed_fraction();
    const SineCosine pair = sine_cosine_of_turns(turns);
    const long double angle =
        two_pi * (static_cast<long double>(turns) - static_cast<long double>(std::nearbyint(turns)));
    // |x| <= pi/4 is rounded twice and the series once: 2 * 2^-53 * pi/4 + 2^-54 = 2.3e-16 at worst; 1.93e-16 is met
    RC_ASSERT(std::abs(static_cast<long double>(pair.sine) - std::sin(angle)) < 2e-16L);
    RC_ASSERT(std::abs(static_cast<long double>(pair.cosine) - std::cos(angle)) < 2e-16L);
}

RC_GTEST_PROP(SineCosine, OfDegreesIsExactToThreeTimesTenToTheMinusSixteen, ()) {
    const double degrees = 360.0 * *signed_fraction();
    const SineCosine pair = sine_cosine_of_degrees(degrees);
    const long double angle = two_pi * static_cast<long double>(degrees) / 360;
    // one rounding more than in turns, that of rest / 90: 3 * 2^-53 * pi/4 + 2^-54 = 3.2e-16 at worst
    RC_ASSERT(std::abs(static_cast<long double>(pair.sine) - std::sin(angle)) < 3.2e-16L);
    RC_ASSERT(std::abs(static_cast<long double>(pair.cosine) - std::cos(angle)) < 3.2e-16L);
}

TEST(SineCosine, QuarterTurnsAreExact) {
    constexpr double sines[] = {0.0, 1.0, 0.0, -1.0};
    for (int quarter = -4000; quarter <= 4000; ++quarter) {
        const auto place = static_cast<std::size_t>(((quarter % 4) + 4) % 4);
        const SineCosine turns = sine_cosine_of_turns(0.25 * quarter);
        const SineCosine degrees = sine_cosine_of_degrees(90.0 * quarter);
        EXPECT_EQ(turns.sine, sines[place]);
        EXPECT_EQ(turns.cosine, sines[(place + 1) % 4]);
        EXPECT_EQ(degrees.sine, sines[place]);
        EXPECT_EQ(degrees.cosine, sines[(place + 1) % 4]);
    }
}

// multiples of 2^-20 degree, so that 180 - a and -a are exact themselves
RC_GTEST_PROP(SineCosine, OfDegreesMirrorsBitForBit, ()) {
    const double a = *whole_between(-360 * (1 << 20), 360 * (1 << 20)) * 0x1p-20;
    const SineCosine pair = sine_cosine_of_degrees(a);
    const SineCosine mirrored = sine_cosine_of_degrees(180.0 - a);
    RC_ASSERT(bits(mirrored.sine) == bits(pair.sine));
    RC_ASSERT(bits(mirrored.cosine) == bits(-pair.cosine));
    const SineCosine negative = sine_cosine_of_degrees(-a);
    RC_ASSERT(negative.sine == -pair.sine);
    RC_ASSERT(bits(negative.cosine) == bits(pair.cosine));
}

RC_GTEST_PROP(SineCosine, OfTurnsMirrorsBitForBit, ()) {
    const double a = *whole_between(-(1 << 30), 1 << 30) * 0x1p-30;
    const SineCosine pair = sine_cosine_of_turns(a);
    const SineCosine mirrored = sine_cosine_of_turns(0.5 - a);
    RC_ASSERT(mirrored.sine == pair.sine);
    RC_ASSERT(mirrored.cosine == -pair.cosine);
}

RC_GTEST_PROP(SineCosine, OfWholeTurnsMoreIsTheSame, ()) {
    const double a = *whole_between(-(1 << 20), 1 << 20) * 0x1p-20;
    const double turns = *whole_between(-100000, 100000);
    RC_ASSERT(bits(sine_cosine_of_turns(a + turns).sine) == bits(sine_cosine_of_turns(a).sine));
    RC_ASSERT(bits(sine_cosine_of_degrees(a + 360.0 * turns).cosine) == bits(sine_cosine_of_degrees(a).cosine));
}

RC_GTEST_PROP(Logarithm, IsAccurateOverAllPositiveDoubles, ()) {
    const double mantissa = 1.5 + 0.5 * *signed_fraction();
    const double x = std::ldexp(mantissa, *whole_between(-1000, 1000));
    RC_PRE(x != 1.0);
    RC_ASSERT(relative_error(logarithm_2(x), std::log2(static_cast<long double>(x))) < 1e-15L);
}

RC_GTEST_PROP(Logarithm, IsAccurateNearOne, ()) {
    const double x = 1.0 + *signed_fraction() * std::ldexp(1.0, -*whole_between(1, 40));
    RC_PRE(x != 1.0);
    RC_ASSERT(relative_error(logarithm_2(x), std::log2(static_cast<long double>(x))) < 1e-15L);
}

TEST(Logarithm, OfPowersOfTwoIsExact) {
    for (int exponent = -1000; exponent <= 1000; ++exponent)
        EXPECT_EQ(logarithm_2(std::ldexp(1.0, exponent)), exponent);
}

RC_GTEST_PROP(Power, IsAccurate, ()) {
    const double x = 999.0 * *signed_fraction();
    RC_ASSERT(relative_error(power_of_2(x), std::exp2(static_cast<long double>(x))) < 1e-15L);
}

TEST(Power, OfWholeNumbersIsExact) {
    for (int exponent = -999; exponent <= 999; ++exponent)
        EXPECT_EQ(power_of_2(exponent), std::ldexp(1.0, exponent));
}

RC_GTEST_PROP(Exponential, IsAccurate, ()) {
    const double x = 699.0 * *signed_fraction();
    RC_ASSERT(relative_error(exponential(x), std::exp(static_cast<long double>(x))) < 4e-16L);
    const double small = std::ldexp(*signed_fraction(), -*whole_between(0, 60));
    RC_ASSERT(relative_error(exponential(small), std::exp(static_cast<long double>(small))) < 4e-16L);
}

// a motion that leaves double precision is found by its engine
TEST(Elementary, LeavesWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(std::isnan(exponential(nan)) && std::isnan(arctangent(nan)));
    for (const double y : {1.0, 1.5, 2.0, 20.0})
        EXPECT_TRUE(std::isnan(power(nan, y))) << y;
    EXPECT_EQ(exponential(-infinity), 0.0);
    EXPECT_EQ(power(infinity, 1.5), power_of_2(999.0));
    EXPECT_NEAR(arctangent(infinity), 0.5 * std::numbers::pi, 1e-15);
}

TEST(Exponential, OfVeryLittleIsNothing) {
    EXPECT_EQ(exponential(0.0), 1.0);
    EXPECT_EQ(exponential(-701.0), 0.0);
    EXPECT_EQ(exponential(-1e300), 0.0);
}

RC_GTEST_PROP(Power, OfAnyBaseIsAccurate, ()) {
    const double x = std::ldexp(1.5 + 0.5 * *signed_fraction(), *whole_between(-40, 40));
    const double y = 10.0 * (1.0 + *signed_fraction());
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    RC_ASSERT(relative_error(power(x, y), exact) < 1e-15L * (1.0L + std::abs(y * std::log2(x))));
}

TEST(Power, OfAFewExponentsIsExact) {
    for (const double x : {0.0, 0.3, 1.0, 7.1}) {
        EXPECT_EQ(power(x, 0.0), 1.0);
        EXPECT_EQ(power(x, 1.0), x);
        EXPECT_EQ(power(x, 2.0), x * x);
    }
    EXPECT_EQ(power(0.0, 0.5), 0.0);
    EXPECT_EQ(power(1e-300, 20.0), 0.0);
    EXPECT_EQ(power(1e300, 20.0), std::ldexp(1.0, 999));
}

RC_GTEST_PROP(ArcTangent, IsAccurate, ()) {
    const double x = std::ldexp(1.5 + 0.5 * *signed_fraction(), *whole_between(-60, 60));
    RC_ASSERT(relative_error(arctangent(x), std::atan(static_cast<long double>(x))) < 4e-16L);
}

TEST(ArcTangent, EndsAtARightAngle) {
    EXPECT_EQ(arctangent(0.0), 0.0);
    EXPECT_NEAR(arctangent(1.0), std::atan(1.0), 2e-16);
    EXPECT_EQ(arctangent(std::numeric_limits<double>::infinity()), std::atan(std::numeric_limits<double>::infinity()));
}

TEST(Decibels, OfAmplitudeRatios) {
    EXPECT_EQ(decibels(1.0), 0.0);
    // relative error of the logarithm, 1e-15
    EXPECT_NEAR(decibels(10.0), 20.0, 20.0 * 1e-15);
    EXPECT_NEAR(decibels(1e-9), -180.0, 180.0 * 1e-15);
    EXPECT_NEAR(decibels(2.0), 6.020599913279624, 6.1 * 1e-15);
}

}  // namespace
}  // namespace stridor::base
