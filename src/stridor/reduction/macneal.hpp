#pragma once

#include "stridor/reduction/condensed_part.hpp"
#include "stridor/reduction/reduction.hpp"

namespace stridor::reduction {

/// Reduces a part to its boundary and its lowest free modes, and what the other modes give way at the boundary
/// (MacNeal, Computers and Structures 1, 1971, 581).
///
/// Statics of the boundary and the frequencies with nothing held are exact. The boundary has no mass, and carries no
/// damping: it follows at once, and an impact law has nothing to act on. `request.inertia` means nothing.
///
/// Throws `Error` (input) for a part that can move freely, and for so many modes that nothing is left to give way;
/// `Error` (numerical) where its modes are not found.
Reduction macneal(const CondensedPart& condensed, const ReductionRequest& request);

}  // namespace stridor::reduction
