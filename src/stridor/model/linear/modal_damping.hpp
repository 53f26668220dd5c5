#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// Returns the damping matrix [N*s/m] that gives each mode of M u'' + K u = 0 the share `ratio` of its critical damping
/// [1]: C = M Φ diag(2 ζ ω) Φ' M with Φ'M Φ = 1. A motion without stiffness is not damped. A motion without mass
/// follows the modes and is not damped either.
///
/// Source: Wilson and Penzien, International Journal for Numerical Methods in Engineering 4 (1972), 5.
Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio);

}  // namespace stridor::model
