#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"

#include <array>
#include <optional>
#include <vector>

namespace stridor::pictures {

/// A law of friction over the speed of slip, as it is drawn. Shape [slip] is that of `model::slips`.
struct LawCurve {
    std::vector<double> speeds;                      // [m/s] rising from 0 to the edge of the picture
    std::array<std::vector<double>, 2> resistances;  // [1] T/N against the slip, shape [slip][speed]
    std::array<double, 2> limits{};                  // [1] of the stick
};

/// Returns the curve of a contact's law, beyond the relative velocities [m/s] that a motion visited.
LawCurve law_curve(const parameters::Contact& contact, std::optional<drawing::Extent> visited = {});

/// Returns a contact with the one law of all contacts of a case. Throws `Error` (input) if they differ.
parameters::Contact one_law(const parameters::Case& c);

/// Draws the friction law of a contact: friction over normal force, over the relative velocity of the plate (Elmaian et
/// al. 2012, Figure 3). A stick takes any ratio up to the static coefficient; a slip has the law's ratio at its
/// velocity. Where static friction grows with rest, its limit after t_0, 10 t_0 and 100 t_0 is dotted. The relative
/// velocities [m/s] that a motion visited are shaded, and within the picture.
drawing::Scene friction_law(const parameters::Contact& contact, std::optional<drawing::Extent> visited = {});

/// Draws the one law of all contacts of a case. Throws `Error` (input) if they differ.
drawing::Scene friction_law_of(const parameters::Case& c, std::optional<drawing::Extent> visited = {});

/// Returns the slip velocities V - t.u' [m/s] between which the first contact of a case slipped in a trace of its run;
/// `std::nullopt` if it never did.
std::optional<drawing::Extent> visited_velocities(const parameters::Case& c, const record::Trace& trace);

}  // namespace stridor::pictures
