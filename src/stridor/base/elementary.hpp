#pragma once

#include <cstddef>
#include <numbers>

namespace stridor::base {

inline constexpr double two_pi = 2.0 * std::numbers::pi;  // [rad] a turn

/// Sine and cosine of one angle.
struct SineCosine {
    double sine = 0.0;    // [1]
    double cosine = 1.0;  // [1]
};

/// Returns sine and cosine of an angle given in turns (1 turn = 360 degrees), with the same bits on every machine.
///
/// The C library chooses its sine by instruction set, and the bits differ with it. This function uses only +, -, * in a
/// fixed order. It is exact at every quarter turn and exactly symmetric: sine(1/2 - a) = sine(a), cosine(1/2 - a) =
/// -cosine(a) where 1/2 - a is itself exact. Its absolute error is below 2e-16 after the reduction, for |turns| < 2^51.
SineCosine sine_cosine_of_turns(double turns);

/// Returns sine and cosine of an angle in degrees, with the same bits on every machine. The angle is reduced in
/// degrees, so that 180 - a mirrors a exactly. One more rounding than in turns: absolute error below 3.2e-16.
SineCosine sine_cosine_of_degrees(double degrees);

/// Returns the logarithm to base 2 of a positive finite number, with the same bits on every machine; relative error
/// below 1e-15.
double logarithm_2(double x);

inline constexpr double log2_of_e = 1.4426950408889634;
inline constexpr double log2_of_ten = 3.321928094887362;

/// Returns 2 to the power x for |x| < 1000, with the same bits on every machine; relative error below 1e-15.
double power_of_2(double x);

/// Returns e to the power x for x < 700, with the same bits on every machine: relative error below 4e-16; 0 below -700.
double exponential(double x);

/// Returns x to the power y for x >= 0 and y >= 0, with the same bits on every machine; relative error below 1e-15
/// times 1 + |y log2 x|. It is exact for y = 0, 1 and 2. Beyond 2^-999 and 2^999 it returns 0 and 2^999.
double power(double x, double y);

/// Returns the arc tangent of x >= 0 [rad], with the same bits on every machine; relative error below 4e-16.
double arctangent(double x);

/// Returns 20 log10(ratio), the level of a positive amplitude ratio [dB].
double decibels(double ratio);

/// Returns the whole part of a value, from 0 to `most`; 0 if the value is NaN.
///
/// Indices and lengths computed from samples or from a user's numbers go through here: C++ does not define the
/// conversion of NaN, or of a double beyond the range of whole numbers.
constexpr std::size_t whole_below(double value, std::size_t most) {
    if (!(value > 0.0)) return 0;
    return value < static_cast<double>(most) ? static_cast<std::size_t>(value) : most;
}

/// Returns the whole number nearest to a value, half a step upwards; from 0 to `most`, and 0 if the value is NaN.
constexpr std::size_t whole_near(double value, std::size_t most) {
    return whole_below(value + 0.5, most);
}

}  // namespace stridor::base
