#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <vector>

namespace stridor::model {

/// Returns the undamped natural angular frequencies [rad/s], rising, of M u'' + K u = 0 with the motions along
/// `blocked` held still.
///
/// The columns of `blocked` [1] are the constraints, shape [dof][constraint]; they must be linearly independent and not
/// zero.
std::vector<double> natural_frequencies(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& blocked);

/// Returns the undamped natural angular frequencies [rad/s], rising, of the structure with all its contacts held in one
/// state; of springs their slopes at rest count.
///
/// Separation: all degrees of freedom free. Slip: the gaps closed, no friction (mu = 0). Stick: gaps closed and the
/// tangential positions fixed. The constraints are n.u = 0 and t.u = 0; the rest is a symmetric eigenvalue problem.
std::vector<double> natural_frequencies(const Structure& structure, ContactState state);

}  // namespace stridor::model
