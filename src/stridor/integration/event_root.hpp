#pragma once

#include "stridor/integration/exact_kernel.hpp"

namespace stridor::integration {

/// First tau in [0, 1] at which an event function stops being positive; `no_crossing` if it does not.
///
/// `series` holds its coefficients over tau, of which the first `multiplicity` are zero but for rounding: the event that
/// has just fired, divided out. `bernstein` is the quotient's Bernstein form of degree 7. Roots are isolated with it and polished
/// on the series to rounding. A quotient that is zero at tau = 0 is judged by its first non-vanishing derivative.
double first_crossing(const Lanes (&series)[term_blocks], int multiplicity, const Lanes& bernstein,
                      const Kernel& loops);

}  // namespace stridor::integration
