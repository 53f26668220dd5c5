#pragma once

#include "stridor/model/contact/equilibrium.hpp"

namespace stridor::model {

/// Returns how a structure rests on its contacts without friction: K u = f0 + sum of n N, with N >= 0, g0 + n.u >= 0
/// and N = 0 where the gap is open.
///
/// Only the stiffness holds the motions that the contacts leave free, so K must be positive definite. The solution is
/// unique then. Pivots by Murty's rule, which ends (Murty, Linear Programming 7, 1974, 345). Throws `Error` (input) if
/// the stiffness does not hold the structure.
Equilibrium static_contact(const Structure& structure);

}  // namespace stridor::model
