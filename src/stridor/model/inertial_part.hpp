#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// The motion of a structure some of which has no mass. Where M is singular, M u = M V y for u = V y + (the rest), what
/// has no mass follows the forces f on it at once:
///
///     u = B y + S f,   S = V0 (V0'K V0)^-1 V0',   B = V - S K V
///
/// V and V0 are orthonormal, of what has mass and of what has none. The equations of y have V'M V and B'K B.
struct InertialPart {
    Eigen::MatrixXd inertial;     // [1] V, shape [dof][inertial]
    Eigen::MatrixXd shape;        // [1] B, likewise
    Eigen::MatrixXd flexibility;  // [m/N] S, shape [dof][dof]; zero where all has mass
};

/// M is positive semidefinite. Throws `Error` (input) where the stiffness does not hold what has no mass.
InertialPart inertial_part(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness);

}  // namespace stridor::model
