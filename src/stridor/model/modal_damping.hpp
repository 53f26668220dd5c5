#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// Damping matrix [N*s/m] that gives each mode of M u'' + K u = 0 this share of its critical damping [1]:
/// C = M Φ diag(2 ζ ω) Φ' M with Φ'M Φ = 1. A motion without stiffness is not damped, nor is what has no mass: that
/// follows the modes.
///
/// Source: Wilson and Penzien, International Journal for Numerical Methods in Engineering 4 (1972), 5.
Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio);

}  // namespace stridor::model
