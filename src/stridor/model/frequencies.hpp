#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>
#include <vector>

namespace stridor::model {

/// Undamped natural angular frequencies [rad/s], rising, of the structure with its contact held in one state.
///
/// Separation: all degrees of freedom free. Slip: the gap closed, no friction (mu = 0). Stick: gap closed and the
/// tangential position fixed. The constraints are n.u = 0 and t.u = 0; the rest is a symmetric eigenvalue problem.
template <int dofs>
std::vector<double> natural_frequencies(const Structure<dofs>& structure, ContactState state) {
    using Dynamic = Eigen::MatrixXd;
    const int constraints = state == ContactState::separation ? 0 : state == ContactState::slip ? 1 : 2;
    // the last columns of Q in [n t] = Q R span the motions the contact leaves free
    Eigen::Matrix<double, dofs, 2> blocked;
    blocked << structure.normal, structure.tangent;
    const Dynamic all = Dynamic(blocked.leftCols(constraints == 0 ? 1 : constraints).householderQr().householderQ());
    const Dynamic free =
        constraints == 0 ? Dynamic(Dynamic::Identity(dofs, dofs)) : Dynamic(all.rightCols(dofs - constraints));
    const Dynamic mass = free.transpose() * structure.mass * free;
    const Dynamic stiffness = free.transpose() * structure.stiffness * free;
    if (mass.rows() == 0) return {};
    const Eigen::GeneralizedSelfAdjointEigenSolver<Dynamic> solver(stiffness, mass, Eigen::EigenvaluesOnly);
    std::vector<double> frequencies;
    for (const double squared : solver.eigenvalues())
        frequencies.push_back(std::sqrt(squared > 0.0 ? squared : 0.0));
    return frequencies;
}

}  // namespace stridor::model
