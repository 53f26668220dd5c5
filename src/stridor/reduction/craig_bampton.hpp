#pragma once

#include "stridor/reduction/condensed_part.hpp"
#include "stridor/reduction/reduction.hpp"

namespace stridor::reduction {

/// Reduces a part to its boundary and the lowest modes with that boundary held (Craig and Bampton, AIAA Journal 6,
/// 1968, 1313).
///
/// Statics of the boundary are exact. The modes have unit mass; a damping is projected. Throws `Error` (numerical) if
/// the modes are not found.
Reduction craig_bampton(const CondensedPart& condensed, const ReductionRequest& request);

/// Reduces a sound part in SI (`expect_sound`, `in_si`). Throws what `CondensedPart` refuses, too.
Reduction craig_bampton(const ElasticPart& part, const ReductionRequest& request);

}  // namespace stridor::reduction
