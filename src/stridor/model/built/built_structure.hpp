#pragma once

#include "stridor/parameters/own_structure.hpp"

namespace stridor::model {

/// Builds structures from the values of a recipe (`parameters::Recipe::build`). A value that the recipe lacks is the
/// default of the builder's own struct. The values must make sense. Contact forces at rest and laws come from the case.

/// Builds `chain_on_belt` from blocks, mass, stiffness, damping, coupling.
parameters::OwnStructure built_chain(const parameters::Recipe& recipe);

/// Builds `bowed_string` from modes, frequency, impedance, length, damping_ratio, bridge_resistance, position; start is
/// "rest" or "helmholtz".
parameters::OwnStructure built_string(const parameters::Recipe& recipe);

/// Builds `cantilever` from modes, length, mass_per_length, bending_stiffness, axial_stiffness, damping_ratio,
/// incidence_angle.
parameters::OwnStructure built_beam(const parameters::Recipe& recipe);

}  // namespace stridor::model
