// Not a template: eigenvalue solvers are slow to compile and are run once per case, so one instance serves all sizes.

#include "stridor/model/frequencies.hpp"

#include "stridor/model/complement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace stridor::model {

std::vector<double> natural_frequencies(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& blocked) {
    const Eigen::MatrixXd free = orthogonal_complement(blocked);
    if (free.cols() == 0) return {};
    const Eigen::MatrixXd free_mass = reduced(free, mass, free);
    const Eigen::MatrixXd free_stiffness = reduced(free, stiffness, free);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(free_stiffness, free_mass,
                                                                           Eigen::EigenvaluesOnly);
    std::vector<double> frequencies;
    for (const double squared : solver.eigenvalues())
        frequencies.push_back(std::sqrt(squared > 0.0 ? squared : 0.0));
    return frequencies;
}

}  // namespace stridor::model
