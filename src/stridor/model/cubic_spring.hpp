#pragma once

#include "stridor/model/structure.hpp"

#include <Eigen/Core>

namespace stridor::model {

/// Returns the spring's force against its elongation e [m], k3 e³ [N].
inline double force_of(const CubicSpring& spring, double elongation) {
    return spring.cubic * elongation * elongation * elongation;
}

/// Returns the linear structure that a structure with cubic springs is next to a displacement u [m], shape [dof]: their
/// tangent stiffness joins K, and what they push there beyond that joins f0. Without such springs it is the same.
///
///     k3 e³ = k3 e0³ + 3 k3 e0² (e - e0) + ...
Structure linearised_at(Structure structure, const Eigen::Ref<const Eigen::VectorXd>& displacement);

}  // namespace stridor::model
