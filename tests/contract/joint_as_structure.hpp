#pragma once

#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/start.hpp"
#include "support/massless_feet.hpp"
#include "support/random_structures.hpp"

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

/// The joint of a case as engines of any size take it, for the contract suite.
namespace stridor::contract {

/// Returns the joint on its plate as a structure of one's own: the rows x1, y1 and y2, and one contact.
inline parameters::Case as_own_structure(parameters::Case c) {
    const model::Structure structure = model::structure_of(c);
    const model::ContactPoint& contact = structure.contacts.front();
    const auto values = [](const Eigen::VectorXd& v) { return std::vector<double>(v.data(), v.data() + v.size()); };
    parameters::OwnStructure own;
    own.row = {"x1", "y1", "y2"};
    own.mass = support::numbers_of(structure.mass);
    own.stiffness = support::numbers_of(structure.stiffness);
    own.damping = support::numbers_of(structure.damping);
    own.contacts.emplace_back();
    own.contacts.front().name = "joint";
    own.contacts.front().normal = values(contact.normal);
    own.contacts.front().tangent = values(contact.tangent);
    own.contacts.front().preload_share = 1.0;
    if (c.run.initial == parameters::Initial::given) {
        const parameters::JointStart& start = c.joints.front().start;
        const bool sticks = start.contact == parameters::ContactStart::stick;
        own.initial_displacement = {start.tangential, start.normal, c.plate.initial_normal};
        own.initial_velocity = {sticks ? parameters::velocity_at_start(c.drive) : start.tangential_velocity,
                                start.normal_velocity, c.plate.initial_normal_velocity};
    }
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    return c;
}

/// Returns the joint on a foot without mass.
inline parameters::Case on_massless_foot(parameters::Case c) {
    return support::on_massless_feet(as_own_structure(std::move(c)));
}

}  // namespace stridor::contract
