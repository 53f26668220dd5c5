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

std::vector<double> natural_frequencies(const Structure& structure, ContactState state) {
    const Eigen::Index each = state == ContactState::separation ? 0 : state == ContactState::slip ? 1 : 2;
    const auto contacts = static_cast<Eigen::Index>(structure.contacts.size());
    Eigen::MatrixXd blocked(dofs_of(structure), each * contacts);
    for (Eigen::Index k = 0; k < contacts; ++k) {
        const ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        if (each > 0) blocked.col(each * k) = contact.normal;
        if (each > 1) blocked.col(each * k + 1) = contact.tangent;
    }
    return natural_frequencies(structure.mass, structure.stiffness, blocked);
}

}  // namespace stridor::model
