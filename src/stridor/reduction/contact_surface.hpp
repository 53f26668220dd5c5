#pragma once

#include "stridor/base/error.hpp"
#include "stridor/reduction/part.hpp"

#include <vector>

namespace stridor::reduction {

/// Returns the reasons to doubt that rows are on the surface and that the normal of their contacts points into the
/// part, in words, each with a remedy.
///
/// `normal` is the component along which a gap opens, from 1 to 3, negative where it opens towards lower coordinates.
/// The nearest nodes that the stiffness couples with a node show on which side the part lies. Nodes without places,
/// lines and sheets are not judged.
std::vector<base::Problem> surface_doubts(const ElasticPart& part, const std::vector<Eigen::Index>& rows, int normal);

}  // namespace stridor::reduction
