#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"

#include <optional>

namespace stridor::pictures {

/// Draws the friction law of a contact: friction over normal force, over the relative velocity of the plate (Elmaian et
/// al. 2012, Figure 3). A stick takes any ratio up to the static coefficient; a slip has the law's ratio at its
/// velocity. The relative velocities [m/s] that a motion visited are shaded, and within the picture.
drawing::Scene friction_law(const parameters::Contact& contact, std::optional<drawing::Extent> visited = {});

/// Draws the one law of all contacts of a case. Throws `Error` (input) if they differ.
drawing::Scene friction_law_of(const parameters::Case& c, std::optional<drawing::Extent> visited = {});

/// Returns the relative velocities V - x1' [m/s] between which the first joint slipped; nothing if it never did.
std::optional<drawing::Extent> visited_velocities(const record::Trace& trace);

}  // namespace stridor::pictures
