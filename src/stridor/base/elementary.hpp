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

/// Sine and cosine of an angle given in turns (1 turn = 360 degrees), the same bits on every machine.
///
/// The C library picks its sine by instruction set and its bits differ with it; this one uses only +, -, * in a fixed
/// order. Exact at every quarter turn and exactly symmetric: sine(1/2 - a) = sine(a), cosine(1/2 - a) = -cosine(a)
/// where 1/2 - a is itself exact. Absolute error below 2e-16 after the reduction, for |turns| < 2^51.
SineCosine sine_cosine_of_turns(double turns);

/// Sine and cosine of an angle in degrees; the same properties, reduced in degrees so that 180 - a mirrors a exactly.
/// One more rounding: absolute error below 3.2e-16.
SineCosine sine_cosine_of_degrees(double degrees);

/// Logarithm to base 2 of a positive finite number, the same bits on every machine; relative error below 1e-15.
double logarithm_2(double x);

/// 2 to the power x for |x| < 1000, the same bits on every machine; relative error below 1e-15.
double power_of_2(double x);

/// 20 log10(ratio), the level of a positive amplitude ratio [dB].
double decibels(double ratio);

/// Returns the whole part of a value, from 0 to `most`, and 0 for what is no number.
///
/// Indices and lengths that are computed from samples or from what a user typed go through here: the conversion of a
/// double beyond the whole numbers, or of NaN, has no meaning in C++.
constexpr std::size_t whole_below(double value, std::size_t most) {
    if (!(value > 0.0)) return 0;
    return value < static_cast<double>(most) ? static_cast<std::size_t>(value) : most;
}

/// Returns the whole number nearest to a value, half a step upwards; from 0 to `most`, and 0 for what is no number.
constexpr std::size_t whole_near(double value, std::size_t most) {
    return whole_below(value + 0.5, most);
}

}  // namespace stridor::base
