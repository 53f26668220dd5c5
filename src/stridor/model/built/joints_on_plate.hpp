#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <span>

namespace stridor::model {

using parameters::PlateJoint;

/// Returns several joints on one plate: the rubbing system of Elmaian et al. (2012), Figure 1, with more than one mass
/// 1.
///
/// Degrees of freedom: along and across the plate of each joint in turn, then the plate across, (x1, y1, x3, y3, ...,
/// y2). Each preload presses its joint down and the plate up. The springs of a joint that stiffens bear it at rest, as
/// far as it acts along them. Throws `Error` (input) for one that never holds it.
Structure joints_on_plate(std::span<const PlateJoint> joints, const parameters::Plate& plate);

}  // namespace stridor::model
