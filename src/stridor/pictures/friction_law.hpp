#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::pictures {

/// Coulomb's law with two coefficients: friction over normal force, over the relative velocity of the plate (Elmaian et
/// al. 2012, Figure 3). Sticking takes any ratio up to the static coefficient; slipping has the kinetic one.
drawing::Scene friction_law(const parameters::Contact& contact);

/// The one law of all contacts of a case. Throws `Error` (input) where they differ.
drawing::Scene friction_law_of(const parameters::Case& c);

}  // namespace stridor::pictures
