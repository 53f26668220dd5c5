#pragma once

#include "stridor/parameters/own_structure.hpp"

namespace stridor::model {

/// Structures from the values of a recipe (`parameters::Recipe::build`). Values that the recipe does not have are those
/// of the builder's own struct; all it has must make sense. Contact forces at rest and laws are the case's.

/// `chain_on_belt`: blocks, mass, stiffness, damping, coupling.
parameters::OwnStructure built_chain(const parameters::Recipe& recipe);

/// `bowed_string`: modes, frequency, impedance, length, damping_ratio, bridge_resistance, position; start is "rest" or
/// "helmholtz".
parameters::OwnStructure built_string(const parameters::Recipe& recipe);

/// `cantilever`: modes, length, mass_per_length, bending_stiffness, axial_stiffness, damping_ratio, incidence_angle.
parameters::OwnStructure built_beam(const parameters::Recipe& recipe);

}  // namespace stridor::model
