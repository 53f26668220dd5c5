#pragma once

#include <span>

namespace stridor::integration {

/// No zero in the interval.
inline constexpr double no_zero = 2.0;

/// What the search came to where a coefficient left double precision; it lies below any zero.
inline constexpr double no_polynomial = -1.0;

/// Returns first place in (0, reach] at which a polynomial that begins positive stops being so; 0 if it begins
/// negative, `no_zero` if it stays positive. `reach` is at most 1.
///
/// `c` are its coefficients. The first `dropped` of them are zero but for rounding, and their power is divided out.
/// Certain: Bernstein's form bounds the polynomial on each part of the interval. Source: as `exact/event_root`.
double first_zero(std::span<const double> c, int dropped, double reach);

/// Returns the first place in (0, reach] at which a function stops being positive whose first coefficients are zero but
/// for rounding, which is `zero` in each of them: the first coefficient above it decides. If that is negative, returns
/// a place up to which its term stays within `zero`.
double late_zero(std::span<const double> c, double zero, double reach);

/// Returns the value of a polynomial at x.
double value_of(std::span<const double> c, double x);

}  // namespace stridor::integration
