#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// Returns the kinetic energy, v.M v / 2 [J], of velocities [m/s] and a mass matrix [kg] of any size.
template <typename Matrix, typename Vector>
double kinetic_energy(const Eigen::MatrixBase<Matrix>& mass, const Eigen::MatrixBase<Vector>& v) {
    return 0.5 * v.dot(mass * v);
}

/// Returns the elastic energy, u.K u / 2 [J], of displacements [m]. The work of the constant load is counted apart.
template <typename Matrix, typename Vector>
double elastic_energy(const Eigen::MatrixBase<Matrix>& stiffness, const Eigen::MatrixBase<Vector>& u) {
    return 0.5 * u.dot(stiffness * u);
}

}  // namespace stridor::model
