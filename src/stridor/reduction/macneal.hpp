#pragma once

#include "stridor/reduction/condensed_part.hpp"
#include "stridor/reduction/reduction.hpp"

namespace stridor::reduction {

/// Reduces a part to its boundary, its lowest free modes, and the flexibility of the other modes at the boundary
/// (MacNeal, Computers and Structures 1, 1971, 581).
///
/// Statics of the boundary and the frequencies with nothing held are exact. The boundary has no mass and carries no
/// damping: it follows at once, and an impact law has no mass to act on. `request.inertia` has no effect.
///
/// Throws `Error` (input) if the part can move freely, or if so many modes are kept that no flexibility is left;
/// `Error` (numerical) if the modes are not found.
Reduction macneal(const CondensedPart& condensed, const ReductionRequest& request);

}  // namespace stridor::reduction
