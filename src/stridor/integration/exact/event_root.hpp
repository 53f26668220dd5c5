#pragma once

#include "stridor/integration/kernels/exact_kernel.hpp"

namespace stridor::integration {

/// What a search came to instead of a root or `no_crossing`: both lie below any root.
inline constexpr double endless_search = -1.0;  // the function is rounding: no interval of it can be decided
inline constexpr double no_number = -2.0;       // a coefficient left double precision

/// Returns first tau in [0, 1] at which an event function stops being positive; `no_crossing` if it does not.
///
/// `series` holds its coefficients over tau, of which the first `multiplicity` are zero but for rounding: the event
/// that has just fired, divided out. `bernstein` is the quotient's Bernstein form of degree 7. Roots are isolated with
/// it and polished on the series to rounding. A quotient that is zero at tau = 0 is judged by its first non-vanishing
/// derivative. The search is bounded: some thousand intervals, ten milliseconds.
double first_crossing(const Lanes (&series)[term_blocks], int multiplicity, const Lanes& bernstein,
                      const Kernel& loops);

}  // namespace stridor::integration
