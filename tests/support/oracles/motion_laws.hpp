#pragma once

#include "stridor/integration/run/motion.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::support {

/// The first law of the model that a motion breaks, in words; empty if it keeps them all.
///
/// Looks at every sample of the trace (equations of motion, Coulomb, unilateral contact), at the history (tiles the
/// time, neighbours different), at the tallies and at the energy balance. Forces come from the sampled displacements,
/// velocities and accelerations, not from what the engine says they are.
std::string broken_law(const parameters::Case& c, const integration::Motion& motion);

}  // namespace stridor::support
