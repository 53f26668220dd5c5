#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// The motion of a structure with massless motions. Where M is singular, M u = M V y for u = V y + (the rest), the
/// massless rest follows the forces f on it at once:
///
///     u = B y + S f,   S = V0 (V0'K V0)^-1 V0',   B = V - S K V
///
/// V and V0 are orthonormal: V spans the motions with mass, V0 those without. The equations of y have V'M V and B'K B.
struct InertialPart {
    Eigen::MatrixXd inertial;     // [1] V, shape [dof][inertial]
    Eigen::MatrixXd shape;        // [1] B, shape [dof][inertial]
    Eigen::MatrixXd flexibility;  // [m/N] S, shape [dof][dof]; zero if every motion has mass
};

/// Returns that split for a positive semidefinite M. Throws `Error` (input) if the stiffness does not hold a massless
/// motion.
InertialPart inertial_part(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness);

}  // namespace stridor::model
