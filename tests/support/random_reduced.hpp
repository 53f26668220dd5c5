#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "support/counter_random.hpp"
#include "support/random_structures.hpp"
#include "support/structures/lattice_part.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor::support {

/// A solid block of random size, mass and stiffness on a surface that moves, reduced to the nodes of its foot, which
/// all rub, and some of its modes. Case k is the same in every run.
inline parameters::Case random_reduced(std::uint64_t number) {
    CounterRandom random(number);
    const auto pick = [&](int least, std::uint64_t more) { return least + static_cast<int>(random.below(more)); };
    const int along = pick(2, 2), up = pick(3, 2);
    reduction::ElasticPart part = lattice_part({along, 2, up}, LatticeSupport::top_held);
    part.mass *= random.decades(30.0, 3000.0);
    part.stiffness *= random.decades(0.1, 10.0);
    const auto boundary = static_cast<Eigen::Index>(3 * part.sets.front().nodes.size());
    reduction::ReductionRequest request{.modes = pick(2, 8)};
    request.inertia = random.one_in(2) ? reduction::BoundaryInertia::lumped : reduction::BoundaryInertia::consistent;
    for (Eigen::Index row = 0; row < boundary; ++row)
        request.boundary.push_back(row);  // the lowest nodes come first
    const reduction::ElasticPart reduced = reduction::craig_bampton(part, request).part;
    parameters::OwnStructure own;
    own.mass = numbers_of(reduced.mass);
    own.stiffness = numbers_of(reduced.stiffness);
    own.following.ratio = random.decades(3e-3, 0.03);
    for (const reduction::RowLabel& label : reduced.labels)
        own.row.push_back(reduction::describe(label));
    for (Eigen::Index row = 0; row < boundary; row += 3) {
        const auto at = static_cast<std::size_t>(row);
        own.contacts.push_back(
            contact_at(part.labels[at].node, own.row.size(), at + 2, at, 3.0 / static_cast<double>(boundary)));
    }
    parameters::Case c;
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    c.contact().preload = random.decades(1.0, 100.0);
    c.contact().static_friction = random.between(0.4, 1.2);
    c.contact().kinetic_friction = c.contact().static_friction * random.between(0.3, 1.0);
    c.drive.kind = parameters::DriveKind::constant;
    const double way = random.one_in(2) ? 1.0 : -1.0;
    c.drive.velocity = way * random.decades(0.02, 0.3);
    return c;
}

}  // namespace stridor::support
