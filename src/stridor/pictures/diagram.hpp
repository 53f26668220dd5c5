#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/diagram.hpp"

#include <vector>

namespace stridor::pictures {

/// Draws a diagram over one parameter (bifurcation diagram), a column per direction: the category as a strip, below it
/// the local extremes of the joint's displacement and the times between beats in the judged part, then each further
/// figure that the study asks for. `cells` come from `sweep::diagram`.
drawing::Scene diagram(const sweep::SweepResult& result, const std::vector<sweep::DiagramCell>& cells);

}  // namespace stridor::pictures
