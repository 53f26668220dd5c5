#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::model {

/// Number of unknowns of the paper's system: u = (x1, y1, y2) [m].
inline constexpr int rubbing_system_dofs = 3;

/// Returns the paper's joint (mass 1) on a plate (mass 2), 3 degrees of freedom (Elmaian et al. 2012, Figure 2).
///
///     Kxx = k1i c^2 + k1j s^2,  Kyy = k1i s^2 + k1j c^2,  Kxy = (k1i - k1j) s c,  C alike;
///     c, s: cosine and sine of the incidence angle
///     n = (0, 1, -1),  t = (1, 0, 0),  f0 = (0, -F, F)
///
/// Several joints stand on the plate one beside the other: u = (x1, y1, x3, y3, ..., y2), a contact each.
Structure rubbing_system(const parameters::Case& c);

}  // namespace stridor::model
