#include "stridor/model/contact/equilibrium.hpp"

#include "stridor/model/linear/linearised.hpp"
#include "stridor/model/sized_structure.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stridor::model {

namespace {

// each takes a third of the way where a spring that stiffens was stretched far too long
constexpr int most_newton_steps = 128;
constexpr double newton_rounding = 1e-14;  // [1] of the displacement, or of a tenth of what a structure moves usually
constexpr double newton_end = 1e-10;       // [1] likewise: what has come no closer has come to no end

Equilibrium linear_equilibrium(const Structure& structure, const std::vector<double>& ratios) {
    const Eigen::Index dofs = dofs_of(structure);
    const auto contacts = static_cast<Eigen::Index>(structure.contacts.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(dofs + contacts, dofs + contacts);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(dofs + contacts);
    system.topLeftCorner(dofs, dofs) = structure.stiffness;
    right.head(dofs) = structure.load;
    for (Eigen::Index k = 0; k < contacts; ++k) {
        const ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        system.col(dofs + k).head(dofs) = -(contact.normal + ratios[static_cast<std::size_t>(k)] * contact.tangent);
        system.row(dofs + k).head(dofs) = contact.normal.transpose();
        right(dofs + k) = -contact.initial_gap;
    }
    const bool is_small = contacts == 1 && dofs <= 3;
    // no rank test: next to the boundary the system is badly scaled, and its solution still right
    const Eigen::VectorXd solution =
        with_size(is_small ? static_cast<int>(dofs) : 0, [&](auto size) -> Eigen::VectorXd {
            constexpr int rows = size == Eigen::Dynamic ? Eigen::Dynamic : size + 1;
            const Eigen::Matrix<double, rows, rows> sized_system = system;
            const Eigen::Matrix<double, rows, 1> sized_right = right;
            const Eigen::Matrix<double, rows, 1> found = sized_system.partialPivLu().solve(sized_right);
            return found;
        });
    return {solution.head(dofs), solution.tail(contacts)};
}

// [N] how far it is from a balance with springs: forces, and gaps times the largest stiffness
double imbalance(const Structure& structure, const std::vector<double>& ratios, const Equilibrium& at) {
    Eigen::VectorXd forces =
        structure.stiffness * at.displacement + spring_forces(structure, at.displacement) - structure.load;
    double gaps = 0.0;
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const ContactPoint& contact = structure.contacts[k];
        forces -= at.normal_forces(static_cast<Eigen::Index>(k)) * (contact.normal + ratios[k] * contact.tangent);
        gaps += std::abs(contact.initial_gap + contact.normal.dot(at.displacement));
    }
    return forces.norm() + gaps * structure.stiffness.cwiseAbs().maxCoeff();
}

// a step of Newton's method, halved until it comes nearer; whole where none does, as at the end
Equilibrium shortened(const Structure& structure, const std::vector<double>& ratios, const Equilibrium& from,
                      const Equilibrium& to) {
    constexpr double least_share = 0x1p-20;
    const double before = imbalance(structure, ratios, from);
    for (double share = 1.0; share > least_share; share *= 0.5) {
        const Equilibrium part{from.displacement + share * (to.displacement - from.displacement),
                               from.normal_forces + share * (to.normal_forces - from.normal_forces)};
        if (imbalance(structure, ratios, part) < before) return share == 1.0 ? to : part;
    }
    return to;
}

}  // namespace

Equilibrium equilibrium(const Structure& structure, const std::vector<double>& ratios) {
    if (structure.springs.empty()) return linear_equilibrium(structure, ratios);
    Equilibrium found{Eigen::VectorXd::Zero(dofs_of(structure)),
                      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(structure.contacts.size()))};
    // it may rest where it is: then all that is found is rounding
    const double least_size = 0.1 * displacement_scale(structure);
    double change = std::numeric_limits<double>::infinity(), size = 0.0;
    for (int step = 0; step < most_newton_steps && !(change <= newton_rounding * size); ++step) {
        const Equilibrium next = shortened(structure, ratios, found,
                                           linear_equilibrium(linearised_at(structure, found.displacement), ratios));
        change = (next.displacement - found.displacement).norm();
        size = std::max(least_size, next.displacement.norm());
        found = next;
    }
    if (change <= newton_end * size) return found;
    found.displacement.setConstant(std::numeric_limits<double>::quiet_NaN());
    found.normal_forces.setConstant(std::numeric_limits<double>::quiet_NaN());
    return found;
}

namespace {

// so many exchanges for each contact have always been enough where there is a solution
constexpr std::size_t exchanges_per_contact = 64;

Structure with_contacts(const Structure& structure, const std::vector<std::size_t>& closed) {
    Structure part = structure;
    part.contacts.clear();
    for (const std::size_t k : closed)
        part.contacts.push_back(structure.contacts[k]);
    return part;
}

template <typename T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& which) {
    std::vector<T> some;
    for (const std::size_t k : which)
        some.push_back(all[k]);
    return some;
}

ClosedContacts with_closed(const Structure& structure, const std::vector<double>& ratios,
                           const std::vector<std::size_t>& closed) {
    const Equilibrium found = equilibrium(with_contacts(structure, closed), chosen(ratios, closed));
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(structure.contacts.size()));
    for (std::size_t k = 0; k < closed.size(); ++k)
        forces(static_cast<Eigen::Index>(closed[k])) = found.normal_forces(static_cast<Eigen::Index>(k));
    return {closed, {found.displacement, forces}};
}

}  // namespace

ClosedContacts closed_contacts(const Structure& structure, const std::vector<double>& ratios) {
    std::vector<std::size_t> closed(structure.contacts.size());
    std::iota(closed.begin(), closed.end(), std::size_t{0});
    const ClosedContacts all = with_closed(structure, ratios, closed);
    if (closed.size() == 1) return all;
    ClosedContacts now = all;
    for (std::size_t exchange = 0; exchange < exchanges_per_contact * structure.contacts.size(); ++exchange) {
        std::size_t violated = 0;
        for (; violated < structure.contacts.size(); ++violated) {
            const ContactPoint& contact = structure.contacts[violated];
            const bool is_closed = std::binary_search(now.closed.begin(), now.closed.end(), violated);
            const double force = now.equilibrium.normal_forces(static_cast<Eigen::Index>(violated));
            const double gap = contact.initial_gap + contact.normal.dot(now.equilibrium.displacement);
            if (is_closed ? !(force > 0.0) : !(gap >= 0.0)) break;
        }
        if (violated == structure.contacts.size()) return now;
        const auto place = std::lower_bound(now.closed.begin(), now.closed.end(), violated);
        if (place != now.closed.end() && *place == violated)
            now.closed.erase(place);
        else
            now.closed.insert(place, violated);
        now = with_closed(structure, ratios, now.closed);
    }
    return all;
}

std::vector<double> sliding_ratios(const Structure& structure, double surface_velocity) {
    std::vector<double> ratios;
    for (const ContactPoint& contact : structure.contacts) {
        const double w = -contact.drive_share * surface_velocity;
        ratios.push_back(slip_ratio(contact.friction, slip_of(w), w));
    }
    return ratios;
}

}  // namespace stridor::model
