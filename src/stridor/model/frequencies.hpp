#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <vector>

namespace stridor::model {

/// Undamped natural angular frequencies [rad/s], rising, of M u'' + K u = 0 with the motions along `blocked` held still.
///
/// The columns of `blocked` [1] are the constraints, shape [dof][constraint]; none may be zero or depend on the others.
std::vector<double> natural_frequencies(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& blocked);

/// Undamped natural angular frequencies [rad/s], rising, of the structure with its contact held in one state.
///
/// Separation: all degrees of freedom free. Slip: the gap closed, no friction (mu = 0). Stick: gap closed and the
/// tangential position fixed. The constraints are n.u = 0 and t.u = 0; the rest is a symmetric eigenvalue problem.
template <int dofs>
std::vector<double> natural_frequencies(const Structure<dofs>& structure, ContactState state) {
    Eigen::MatrixXd blocked(dofs, 2);
    blocked << structure.normal, structure.tangent;
    const int constraints = state == ContactState::separation ? 0 : state == ContactState::slip ? 1 : 2;
    return natural_frequencies(structure.mass, structure.stiffness, blocked.leftCols(constraints));
}

}  // namespace stridor::model
