#pragma once

#include "stridor/model/structure.hpp"

#include <Eigen/LU>

namespace stridor::model {

/// A state of rest or of steady sliding: displacements and normal force that balance.
template <int dofs>
struct Equilibrium {
    typename Structure<dofs>::Vector displacement;  // [m] u
    double normal_force = 0.0;                      // [N] N
};

/// Solves K u = f0 + (n + signed_friction t) N with the contact closed, n.u = 0.
///
/// `signed_friction` is T/N: 0 at rest, +mu_d while the surface moves going (V > 0), -mu_d coming. A negative
/// normal force or a singular system (the divergence boundary) comes out as such; the caller decides.
template <int dofs>
Equilibrium<dofs> equilibrium(const Structure<dofs>& structure, double signed_friction) {
    using Bordered = Eigen::Matrix<double, dofs + 1, dofs + 1>;
    Bordered system = Bordered::Zero();
    system.template topLeftCorner<dofs, dofs>() = structure.stiffness;
    system.template topRightCorner<dofs, 1>() = -(structure.normal + signed_friction * structure.tangent);
    system.template bottomLeftCorner<1, dofs>() = structure.normal.transpose();
    Eigen::Matrix<double, dofs + 1, 1> right = Eigen::Matrix<double, dofs + 1, 1>::Zero();
    right.template head<dofs>() = structure.load;
    // no rank test: next to the boundary the system is badly scaled, and its solution still right
    const Eigen::Matrix<double, dofs + 1, 1> solution = system.partialPivLu().solve(right);
    return {solution.template head<dofs>(), solution(dofs)};
}

}  // namespace stridor::model
