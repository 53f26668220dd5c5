#include "stridor/model/linear/frequencies.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/model/linear/complement.hpp"
#include "stridor/model/linear/inertial_part.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <cmath>

namespace stridor::model {

std::vector<double> natural_frequencies(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        const Eigen::MatrixXd& blocked) {
    const Eigen::MatrixXd free = orthogonal_complement(blocked);
    if (free.cols() == 0) return {};
    Eigen::MatrixXd free_mass = reduced(free, mass, free);
    Eigen::MatrixXd free_stiffness = reduced(free, stiffness, free);
    if (Eigen::LLT<Eigen::MatrixXd>(free_mass).info() != Eigen::Success) {
        const InertialPart part = inertial_part(free_mass, free_stiffness);
        free_mass = reduced(part.inertial, free_mass, part.inertial);
        free_stiffness = reduced(part.shape, free_stiffness, part.shape);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(free_stiffness, free_mass,
                                                                           Eigen::EigenvaluesOnly);
    std::vector<double> frequencies;
    for (const double squared : solver.eigenvalues())
        frequencies.push_back(std::sqrt(squared > 0.0 ? squared : 0.0));
    return frequencies;
}

std::vector<double> natural_frequencies(const Structure& structure, ContactState state) {
    std::vector<const Eigen::VectorXd*> held;
    for (const ContactPoint& contact : structure.contacts) {
        if (state != ContactState::separation) held.push_back(&contact.normal);
        if (state != ContactState::stick) continue;
        held.push_back(&contact.tangent);
        if (has_two_tangents(contact)) held.push_back(&contact.second_tangent);
    }
    Eigen::MatrixXd blocked(dofs_of(structure), static_cast<Eigen::Index>(held.size()));
    for (std::size_t k = 0; k < held.size(); ++k)
        blocked.col(static_cast<Eigen::Index>(k)) = *held[k];
    return natural_frequencies(structure.mass, linearised_at_rest(structure).stiffness, blocked);
}

}  // namespace stridor::model
