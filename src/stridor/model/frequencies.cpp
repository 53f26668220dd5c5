// Not a template: eigenvalue solvers are slow to compile and are run once per case, so one instance serves all sizes.

#include "stridor/model/frequencies.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>

namespace stridor::model {

std::vector<double> natural_frequencies(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& blocked) {
    const Eigen::Index size = mass.rows();
    Eigen::MatrixXd free = Eigen::MatrixXd::Identity(size, size);
    if (blocked.cols() > 0) {
        // the last columns of Q in blocked = Q R span the motions the constraints leave free
        const Eigen::MatrixXd all = blocked.householderQr().householderQ();
        free = all.rightCols(size - blocked.cols());
    }
    if (free.cols() == 0) return {};
    const Eigen::MatrixXd free_mass = free.transpose() * mass * free;
    const Eigen::MatrixXd free_stiffness = free.transpose() * stiffness * free;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(free_stiffness, free_mass,
                                                                           Eigen::EigenvaluesOnly);
    std::vector<double> frequencies;
    for (const double squared : solver.eigenvalues())
        frequencies.push_back(std::sqrt(squared > 0.0 ? squared : 0.0));
    return frequencies;
}

}  // namespace stridor::model
