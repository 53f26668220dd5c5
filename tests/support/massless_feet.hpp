#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "support/random_structures.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor::support {

/// Returns a structure of one's own whose contacts touch by feet without mass, each on a spring of 1e7 N/m along and
/// one across. It starts at rest: what has no inertia has no other start.
inline parameters::Case on_massless_feet(parameters::Case c) {
    using Eigen::Index;
    using Eigen::MatrixXd;
    using Eigen::VectorXd;
    parameters::OwnStructure own = *c.own_structure;
    const auto rows = static_cast<Index>(own.row.size());
    const auto feet = static_cast<Index>(2 * own.contacts.size());
    const auto enlarged = [&](std::vector<double>& matrix) {
        MatrixXd larger = MatrixXd::Zero(rows + feet, rows + feet);
        if (!matrix.empty()) larger.topLeftCorner(rows, rows) = Eigen::Map<const MatrixXd>(matrix.data(), rows, rows);
        return larger;
    };
    MatrixXd stiffness = enlarged(own.stiffness);
    for (Index foot = 0; foot < feet; ++foot) {
        parameters::OwnContact& contact = own.contacts[static_cast<std::size_t>(foot / 2)];
        std::vector<double>& direction = foot % 2 == 0 ? contact.normal : contact.tangent;
        VectorXd spring = VectorXd::Zero(rows + feet);
        spring.head(rows) = Eigen::Map<const VectorXd>(direction.data(), rows);
        spring(rows + foot) = -1.0;
        stiffness += 1e7 * spring * spring.transpose();
        direction.assign(static_cast<std::size_t>(rows + feet), 0.0);
        direction[static_cast<std::size_t>(rows + foot)] = 1.0;
        own.row.push_back("foot" + std::to_string(foot + 1));
    }
    own.mass = numbers_of(enlarged(own.mass));
    if (!own.damping.empty()) own.damping = numbers_of(enlarged(own.damping));
    own.stiffness = numbers_of(stiffness);
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    c.run.initial = parameters::Initial::rest;
    return c;
}

}  // namespace stridor::support
