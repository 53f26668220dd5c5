#pragma once

#include "stridor/base/error.hpp"
#include "stridor/reduction/part.hpp"

#include <vector>

namespace stridor::reduction {

/// What makes it doubtful that rows are on the surface and that the normal of their contacts points into the part, in
/// words, with what to do.
///
/// `normal` is the component along which a gap opens, from 1 to 3, negative where it opens towards lower coordinates.
/// Where the part goes on is told by the nearest nodes that the stiffness couples with a node; of nodes without places,
/// of lines and of sheets nothing is said.
std::vector<base::Problem> surface_doubts(const ElasticPart& part, const std::vector<Eigen::Index>& rows, int normal);

}  // namespace stridor::reduction
