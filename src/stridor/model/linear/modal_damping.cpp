#include "stridor/model/linear/modal_damping.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/model/linear/inertial_part.hpp"

#include <cmath>

namespace stridor::model {

Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio) {
    const InertialPart part = inertial_part(mass, stiffness);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        part.shape.transpose() * stiffness * part.shape, part.inertial.transpose() * mass * part.inertial);
    const Eigen::MatrixXd momenta = mass * (part.inertial * solver.eigenvectors());
    Eigen::VectorXd rates = solver.eigenvalues();
    for (double& rate : rates)
        rate = rate > 0.0 ? 2.0 * ratio * std::sqrt(rate) : 0.0;
    const Eigen::MatrixXd damping = momenta * rates.asDiagonal() * momenta.transpose();
    return 0.5 * (damping + damping.transpose());
}

}  // namespace stridor::model
