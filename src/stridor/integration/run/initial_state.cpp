#include "stridor/integration/run/initial_state.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/parameters/start.hpp"
#include "stridor/parameters/system.hpp"

#include <string>
#include <utility>
#include <vector>

namespace stridor::integration {

namespace {

// closed contacts move with these tangential velocities, and the structure with the least kinetic energy:
// v = M^-1 R (R'M^-1 R)^-1 (0; w); a second tangent moves with its share of the surface
Eigen::VectorXd least_velocity(const model::Structure& structure, const Eigen::VectorXd& tangential,
                               double surface_velocity = 0.0) {
    const auto p = static_cast<Eigen::Index>(structure.contacts.size());
    std::vector<std::pair<const Eigen::VectorXd*, double>> seconds;
    for (const model::ContactPoint& contact : structure.contacts)
        if (model::has_two_tangents(contact))
            seconds.emplace_back(&contact.second_tangent, contact.second_drive_share * surface_velocity);
    const auto more = static_cast<Eigen::Index>(seconds.size());
    Eigen::MatrixXd rows(model::dofs_of(structure), 2 * p + more);
    for (Eigen::Index k = 0; k < p; ++k) {
        rows.col(k) = structure.contacts[static_cast<std::size_t>(k)].normal;
        rows.col(p + k) = structure.contacts[static_cast<std::size_t>(k)].tangent;
    }
    Eigen::VectorXd velocities = Eigen::VectorXd::Zero(2 * p + more);
    velocities.segment(p, p) = tangential;
    for (Eigen::Index k = 0; k < more; ++k) {
        rows.col(2 * p + k) = *seconds[static_cast<std::size_t>(k)].first;
        velocities(2 * p + k) = seconds[static_cast<std::size_t>(k)].second;
    }
    const Eigen::MatrixXd pushed = structure.mass.ldlt().solve(rows);
    const Eigen::MatrixXd compliance = rows.transpose() * pushed;
    return pushed * compliance.ldlt().solve(velocities);
}

// contacts that are open have nothing to move with
model::Structure with_closed_contacts(model::Structure structure) {
    std::erase_if(structure.contacts, [](const model::ContactPoint& contact) { return contact.initial_gap > 0.0; });
    return structure;
}

InitialState state_at(const parameters::CaseStart& start) {
    const auto vector_of = [](const std::vector<double>& numbers) -> Eigen::VectorXd {
        return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
    };
    return {vector_of(start.displacement), vector_of(start.velocity), start.contacts, nullptr, start.friction_states};
}

double sum_of_sizes(const Eigen::VectorXd& row, const Eigen::VectorXd& numbers) {
    return row.cwiseAbs().dot(numbers.cwiseAbs());
}

// what each contact does there; throws where none may
InitialState lawful_start(const parameters::Case& c, const model::Structure& structure, double surface_velocity) {
    InitialState state = state_at(parameters::start_of(c, surface_velocity));
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const model::ContactPoint& point = structure.contacts[k];
        const double moved = point.drive_share * surface_velocity;
        parameters::StartingContact contact{.name = parameters::told_name(c, k), .state = state.contacts[k]};
        contact.gap = point.initial_gap + point.normal.dot(state.displacement);
        contact.gap_size = std::abs(point.initial_gap) + sum_of_sizes(point.normal, state.displacement) +
                           sum_of_sizes(point.tangent, state.displacement);
        contact.rate = point.normal.dot(state.velocity);
        contact.slip = point.tangent.dot(state.velocity) - moved;
        contact.slip_size = sum_of_sizes(point.tangent, state.velocity) + std::abs(moved);
        contact.rate_size = sum_of_sizes(point.normal, state.velocity) + contact.slip_size;
        if (const std::optional<base::Problem> problem = parameters::unlawful(contact))
            throw Error(ErrorKind::input, *problem);
        state.contacts[k] = parameters::state_of(contact);
    }
    return state;
}

}  // namespace

InitialState initial_state(const model::Structure& given, const Start& start, double surface_velocity) {
    if (start.given) return *start.given;
    const model::Structure structure = model::in_canonical_order(given);
    using parameters::Initial;
    if (start.kind == Initial::sliding && surface_velocity == 0.0)
        throw Error(ErrorKind::input, {"initial = \"sliding\" has no direction", "the drive stands still at the start",
                                       "Start with initial = \"rest\"."});
    const auto p = static_cast<Eigen::Index>(structure.contacts.size());
    const std::vector<double> ratios = start.kind == Initial::sliding
                                           ? model::sliding_ratios(structure, surface_velocity)
                                           : std::vector<double>(structure.contacts.size(), 0.0);
    const model::Equilibrium balance = model::equilibrium(structure, ratios);
    if (!(balance.normal_forces.minCoeff() > 0.0))
        throw Error(ErrorKind::numerical, {"steady sliding has no equilibrium in this direction",
                                           "its normal force would be negative: the contact digs in (sprag-slip)",
                                           "Start with initial = \"rest\"."});
    Eigen::VectorXd tangential = Eigen::VectorXd::Zero(p);
    for (Eigen::Index k = 0; k < p; ++k) {
        if (start.kind == Initial::stuck)
            tangential(k) = structure.contacts[static_cast<std::size_t>(k)].drive_share * surface_velocity;
        if (start.kind == Initial::sliding) tangential(k) = start.perturbation;
    }
    const bool has_plane = model::has_two_tangents(structure.contacts.front());
    InitialState state{balance.displacement, {}};
    if (p > 1 || has_plane) {
        state.velocity = least_velocity(structure, tangential, start.kind == Initial::stuck ? surface_velocity : 0.0);
    } else {
        const model::ContactPoint& contact = structure.contacts.front();
        state.velocity = contact.tangent / contact.tangent.squaredNorm() * tangential(0);
    }
    if (start.kind == Initial::sliding)
        for (const model::ContactPoint& contact : given.contacts)
            state.friction_states.push_back(
                model::steady_friction_state(contact.friction, -contact.drive_share * surface_velocity));
    return state;
}

InitialState initial_state(const parameters::Case& c, const model::Structure& structure, double surface_velocity) {
    STRIDOR_EXPECT(static_cast<int>(parameters::coordinate_count(c)) == model::dofs_of(structure));
    if (c.run.initial == parameters::Initial::given) return lawful_start(c, structure, surface_velocity);
    if (parameters::has_plate(c))
        return initial_state(structure, {c.run.initial, c.run.perturbation}, surface_velocity);
    STRIDOR_EXPECT(c.run.initial != parameters::Initial::sliding);
    const InitialState added = state_at(parameters::start_of(c, surface_velocity));
    const Eigen::Index rows = model::dofs_of(structure);
    InitialState start{Eigen::VectorXd::Zero(rows), Eigen::VectorXd::Zero(rows)};
    if (c.run.initial == parameters::Initial::stuck) {
        const model::Structure closed = with_closed_contacts(model::in_canonical_order(structure));
        Eigen::VectorXd tangential(static_cast<Eigen::Index>(closed.contacts.size()));
        for (std::size_t k = 0; k < closed.contacts.size(); ++k)
            tangential(static_cast<Eigen::Index>(k)) = closed.contacts[k].drive_share * surface_velocity;
        start.velocity = least_velocity(closed, tangential, surface_velocity);
    }
    start.displacement += added.displacement;
    start.velocity += surface_velocity * added.velocity;
    start.friction_states = added.friction_states;
    return start;
}

}  // namespace stridor::integration
