#include "stridor/model/contact/static_contact.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <algorithm>
#include <vector>

namespace stridor::model {

namespace {

using Eigen::Index;

// N of the closed contacts, zero of the others, and the gaps of all: g = free + G N
struct Contacts {
    Eigen::VectorXd normal_forces;  // [N]
    Eigen::VectorXd gaps;           // [m]
};

Contacts closed(const std::vector<Index>& set, const Eigen::MatrixXd& flexibility, const Eigen::VectorXd& free) {
    Contacts found{Eigen::VectorXd::Zero(free.size()), free};
    if (set.empty()) return found;
    const Eigen::MatrixXd inner = flexibility(set, set);
    const Eigen::VectorXd forces = inner.ldlt().solve(-free(set));
    found.normal_forces(set) = forces;
    found.gaps += flexibility(Eigen::all, set) * forces;
    return found;
}

Equilibrium linear_static_contact(const Structure& structure) {
    const Eigen::LLT<Eigen::MatrixXd> factor(structure.stiffness);
    if (factor.info() != Eigen::Success)
        base::refuse("the stiffness alone does not hold the structure",
                     "where it rests under a load or pressed gaps is not determined",
                     "Hold it, or press it by contact.preload with preload_share of each contact.");
    const auto p = static_cast<Index>(structure.contacts.size());
    Eigen::MatrixXd normals(dofs_of(structure), p);
    Eigen::VectorXd free(p);
    for (Index k = 0; k < p; ++k)
        normals.col(k) = structure.contacts[static_cast<std::size_t>(k)].normal;
    const Eigen::VectorXd loose = factor.solve(structure.load);
    const Eigen::MatrixXd moved = factor.solve(normals);
    const Eigen::MatrixXd flexibility = normals.transpose() * moved;
    for (Index k = 0; k < p; ++k)
        free(k) = structure.contacts[static_cast<std::size_t>(k)].initial_gap + normals.col(k).dot(loose);

    // the first contact that breaks a law changes; what is smaller than rounding breaks none
    const double rounding = 1e-12;
    const Eigen::VectorXd size = flexibility.diagonal();
    const double most_gap = free.cwiseAbs().maxCoeff();
    std::vector<bool> is_closed(static_cast<std::size_t>(p), true);
    constexpr long most_pivots = 1'000'000;
    for (long pivot = 0; pivot < most_pivots; ++pivot) {
        std::vector<Index> set;
        for (Index k = 0; k < p; ++k)
            if (is_closed[static_cast<std::size_t>(k)]) set.push_back(k);
        const Contacts found = closed(set, flexibility, free);
        Index worst = p;
        for (Index k = 0; k < p && worst == p; ++k) {
            const bool pulls = found.normal_forces(k) * size(k) < -rounding * most_gap;
            const bool overlaps = found.gaps(k) < -rounding * most_gap;
            if (is_closed[static_cast<std::size_t>(k)] ? pulls : overlaps) worst = k;
        }
        if (worst == p) return {loose + moved * found.normal_forces.cwiseMax(0.0), found.normal_forces.cwiseMax(0.0)};
        is_closed[static_cast<std::size_t>(worst)] = !is_closed[static_cast<std::size_t>(worst)];
    }
    throw Error(ErrorKind::numerical, {"where the structure rests on its contacts was not found",
                                       "contacts change without end", "Do two of them have the same normal?"});
}

}  // namespace

// with springs: by Newton's method, from the structure without load
Equilibrium static_contact(const Structure& structure) {
    if (structure.springs.empty()) return linear_static_contact(structure);
    constexpr int most_steps = 128;
    constexpr double rounding = 1e-14, no_end = 1e-10;  // [1] of the displacement
    const double least_size = 0.1 * displacement_scale(structure);
    Eigen::VectorXd at = Eigen::VectorXd::Zero(dofs_of(structure));
    for (int step = 0; step < most_steps; ++step) {
        const Equilibrium next = linear_static_contact(linearised_at(structure, at));
        const double change = (next.displacement - at).norm();
        const double size = std::max(least_size, next.displacement.norm());
        at = next.displacement;
        if (change <= (step + 1 < most_steps ? rounding : no_end) * size) return next;
    }
    base::refuse("where the structure rests on its springs and contacts was not found",
                 "the steps towards it come to no end", "Do springs soften, or does nothing hold the structure?");
}

}  // namespace stridor::model
