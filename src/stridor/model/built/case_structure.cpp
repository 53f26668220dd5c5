#include "stridor/model/built/case_structure.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/contact/static_contact.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "stridor/model/linear/modal_damping.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stridor::model {

namespace {

using Eigen::Index;
using parameters::OwnStructure;

Eigen::VectorXd vector_of(const std::vector<double>& numbers, Index rows) {
    if (numbers.empty()) return Eigen::VectorXd::Zero(rows);
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), rows);
}

// both triangles are there: the order of rows and columns does not matter
Eigen::MatrixXd matrix_of(const std::vector<double>& numbers, Index rows) {
    if (numbers.empty()) return Eigen::MatrixXd::Zero(rows, rows);
    return Eigen::Map<const Eigen::MatrixXd>(numbers.data(), rows, rows);
}

Eigen::MatrixXd damping_of(const OwnStructure& own, const Structure& structure) {
    const parameters::FollowingDamping& following = own.following;
    Eigen::MatrixXd damping = matrix_of(own.damping, structure.mass.rows());
    if (following.rayleigh_mass != 0.0) damping += following.rayleigh_mass * structure.mass;
    if (following.rayleigh_stiffness != 0.0) damping += following.rayleigh_stiffness * structure.stiffness;
    const double ratio = following.ratio + 0.5 * following.loss_factor;
    if (ratio != 0.0) damping += modal_damping(structure.mass, structure.stiffness, ratio);
    return damping;
}

// [N] of the case; 0 where others press it
double preload_of(const parameters::Case& c) {
    return parameters::is_preloaded(c) ? c.contact().preload : 0.0;
}

// its forces times a scale; `preload` [N] tells how far it is pressed as a rule
SpringLaw law_of(const parameters::OwnSpring& spring, double scale, double preload) {
    using parameters::SpringKind;
    const auto scaled = [&](std::vector<double> forces) {
        for (double& force : forces)
            force *= scale;
        return forces;
    };
    switch (kind_of(spring)) {
        case SpringKind::table:
            return table_spring(spring.table.deflections, scaled(spring.table.forces), spring.interpolation);
        case SpringKind::power:
            return power_spring(scale * spring.force, spring.deflection, spring.exponent, spring.gap, preload);
        case SpringKind::cubic:
        case SpringKind::linear:
            break;
    }
    return CubicSpring{scale * spring.cubic};
}

// the linear parts join the stiffness, the others the springs
void add_springs(Structure& structure, const parameters::Case& c) {
    const parameters::StructureScales& scales = c.structure_scales;
    for (const parameters::OwnSpring& given : c.own_structure->springs) {
        const Eigen::VectorXd direction = vector_of(given.direction, structure.load.size());
        structure.stiffness += scales.stiffness * given.stiffness * direction * direction.transpose();
        if (kind_of(given) == parameters::SpringKind::linear) continue;
        Spring spring{direction, law_of(given, scales.stiffness * scales.springs, preload_of(c))};
        const double borne = given.preload_share * preload_of(c);
        if (borne > 0.0) spring.rest = elongation_under(spring.law, scales.stiffness * given.stiffness, borne);
        if (!std::isfinite(spring.rest))
            base::refuse("spring \"" + given.name + "\" never pushes with " + base::shortest(borne) + " N",
                         "that is its share of the preload at rest", "Lower its preload_share, or make it stiffer.");
        structure.springs.push_back(std::move(spring));
    }
}

void press_by_preload(Structure& structure, const parameters::Case& c) {
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        ContactPoint& contact = structure.contacts[k];
        contact.preload = parameters::contact_of(c, k).preload;
        structure.load -= contact.preload * contact.normal;
    }
    hold_springs(structure);
}

// a body that moves at the start may meet a surface that nothing presses it on
bool is_flying(const OwnStructure& own) {
    return std::any_of(own.initial_velocity.begin(), own.initial_velocity.end(), [](double v) { return v != 0.0; });
}

// from here on displacements are those from the place where it rests
void press_by_load(Structure& structure, const OwnStructure& own) {
    const bool has_overlap = std::any_of(structure.contacts.begin(), structure.contacts.end(),
                                         [](const ContactPoint& contact) { return contact.initial_gap < 0.0; });
    if (structure.load.isZero(0.0) && !has_overlap && is_flying(own)) return;
    const Equilibrium rest = static_contact(structure);
    if (!(rest.normal_forces.maxCoeff() > 0.0) && !is_flying(own))
        base::refuse("no contact is closed at rest", "the load does not press the structure on its contacts",
                     "Check the signs of load and normals, or give contacts a negative initial_gap.");
    structure.load.setZero();
    for (Spring& spring : structure.springs)
        spring.rest += spring.direction.dot(rest.displacement);
    hold_springs(structure);
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        ContactPoint& contact = structure.contacts[k];
        const double force = rest.normal_forces(static_cast<Index>(k));
        structure.load -= force * contact.normal;
        contact.preload = std::max(0.0, force);
        const double gap = contact.initial_gap + contact.normal.dot(rest.displacement);
        contact.initial_gap = force > 0.0 || gap < 0.0 ? 0.0 : gap;
    }
}

Structure structure_of_own(const parameters::Case& c) {
    const OwnStructure& own = *c.own_structure;
    const auto rows = static_cast<Index>(own.row.size());
    const auto count = static_cast<Index>(own.contacts.size());
    Structure structure = structure_of_size(static_cast<int>(rows), static_cast<int>(count));
    structure.mass = matrix_of(own.mass, rows);
    structure.stiffness = c.structure_scales.stiffness * matrix_of(own.stiffness, rows);
    structure.load = vector_of(own.load, rows);
    add_springs(structure, c);
    structure.damping = c.structure_scales.damping * damping_of(own, structure);
    structure.left_out_above = own.left_out_above;
    if (parameters::is_by_force(c.drive)) structure.shaken = vector_of(own.force, rows);
    structure.measured = Eigen::MatrixXd(2 * count, rows);
    const std::vector<int> interfaces = parameters::interface_numbers(own);
    for (Index k = 0; k < count; ++k) {
        const parameters::OwnContact& given = own.contacts[static_cast<std::size_t>(k)];
        const parameters::Contact laws = parameters::contact_of(c, static_cast<std::size_t>(k));
        ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        contact.normal = vector_of(given.normal, rows);
        contact.tangent = vector_of(given.tangent, rows);
        if (!given.second_tangent.empty()) {
            contact.second_tangent = vector_of(given.second_tangent, rows);
            contact.second_drive_share = given.second_drive_share;
        }
        contact.initial_gap = given.initial_gap;
        contact.drive_share = given.drive_share;
        contact.interface = interfaces[static_cast<std::size_t>(k)];
        contact.friction = friction_law(laws);
        contact.rest = rest_growth(laws);
        contact.impact = impact_law(laws);
        structure.measured.row(2 * k) = contact.tangent.transpose();
        structure.measured.row(2 * k + 1) = contact.normal.transpose();
        structure.body.insert(structure.body.end(), {static_cast<int>(k), static_cast<int>(k)});
    }
    if (parameters::is_preloaded(c))
        press_by_preload(structure, c);
    else
        press_by_load(structure, own);
    return structure;
}

}  // namespace

Structure structure_of(const parameters::Case& c) {
    Structure structure = c.own_structure ? structure_of_own(c) : rubbing_system(c);
    for (ContactPoint& contact : structure.contacts)
        contact.creep_speed = c.verdict.creep_speed;
    return structure;
}

}  // namespace stridor::model
