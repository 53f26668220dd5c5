#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <cstdint>

namespace stridor::support {

/// A structure, how its surface moves, how its motion begins and how long it is watched.
struct WildStructure {
    model::Structure structure;
    parameters::Drive drive;
    parameters::Initial initial = parameters::Initial::rest;
    double duration = 0.0;  // [s]
};

/// A structure far from any sensible one: 2 to 60 degrees of freedom, 1 to 8 contacts, inertia, stiffness, damping,
/// friction, gaps and loads over many decades, with a taste for the values at which something vanishes. Structure k is
/// the same in every run. Contacts never outnumber half of its degrees of freedom, so that their forces are determined.
///
/// It lasts for some tens to some hundreds of the engine's blocks.
WildStructure wild_structure(std::uint64_t number);

}  // namespace stridor::support
