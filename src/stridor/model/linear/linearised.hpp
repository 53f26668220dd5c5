#pragma once

#include "stridor/model/structure.hpp"

#include <Eigen/Core>

namespace stridor::model {

/// Returns the linear structure that a structure with springs is next to a displacement u [m], shape [dof]: their
/// tangent stiffness joins K, and what they push there beyond that joins f0. Without springs it is the same.
///
///     F(e) = F(e0) + F'(e0) (e - e0) + ...
Structure linearised_at(Structure structure, const Eigen::Ref<const Eigen::VectorXd>& displacement);

/// Returns the same next to the rest of a case, u = 0.
Structure linearised_at_rest(Structure structure);

/// Adds to the load what the springs push where u = 0, which it holds there.
void hold_springs(Structure& structure);

/// Returns about how far its load and springs move a structure [m]: what is smaller by many digits is rounding.
double displacement_scale(const Structure& structure);

/// Returns what the springs push against a displacement u [m], shape [dof]: sum of F(e) d [N].
Eigen::VectorXd spring_forces(const Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& displacement);

}  // namespace stridor::model
