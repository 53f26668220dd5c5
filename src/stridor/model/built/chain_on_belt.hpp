#pragma once

#include "stridor/model/structure.hpp"

#include <vector>

namespace stridor::model {

/// A block of a chain.
struct ChainBlock {
    double mass = 1.0;       // [kg]
    double stiffness = 1.0;  // [N/m] of the spring from the block to the ground
    double damping = 0.0;    // [N*s/m] of the damper beside that spring
    double preload = 1.0;    // [N] force that presses the block on the belt
    FrictionLaw friction{};
};

/// Returns blocks in a row on a belt, each tied to its neighbours by springs of one stiffness: Burridge and Knopoff's
/// (1967) chain with Coulomb's law.
///
/// Degrees of freedom: along and across the belt of each block in turn. Across the belt a block has its own mass and
/// spring, and rests on the belt.
Structure chain_on_belt(const std::vector<ChainBlock>& blocks, double coupling_stiffness);

}  // namespace stridor::model
