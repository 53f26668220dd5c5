#include "stridor/model/modal_damping.hpp"

#include "stridor/base/decompositions.hpp"

#include <cmath>

namespace stridor::model {

Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
    const Eigen::MatrixXd momenta = mass * solver.eigenvectors();
    Eigen::VectorXd rates = solver.eigenvalues();
    for (double& rate : rates)
        rate = rate > 0.0 ? 2.0 * ratio * std::sqrt(rate) : 0.0;
    const Eigen::MatrixXd damping = momenta * rates.asDiagonal() * momenta.transpose();
    return 0.5 * (damping + damping.transpose());
}

}  // namespace stridor::model
