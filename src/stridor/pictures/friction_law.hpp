#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::pictures {

/// Draws the friction law of a contact: friction over normal force, over the relative velocity of the plate (Elmaian et
/// al. 2012, Figure 3). A stick takes any ratio up to the static coefficient; a slip has the law's ratio at its
/// velocity.
drawing::Scene friction_law(const parameters::Contact& contact);

/// Draws the one law of all contacts of a case. Throws `Error` (input) if they differ.
drawing::Scene friction_law_of(const parameters::Case& c);

}  // namespace stridor::pictures
