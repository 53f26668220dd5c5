#pragma once

#include "stridor/analysis/friction/fit.hpp"
#include "stridor/analysis/friction/over_conditions.hpp"
#include "stridor/drawing/scene.hpp"

#include <cstddef>

namespace stridor::pictures {

/// Draws friction over the speed of slip: the points that were measured, the law with its place in `fit.laws` and those
/// that the data do not tell from it; below, what the law leaves of the points. Of a fit to slips it draws their
/// samples from the release on, over the force at which each let go, and the motion of the rig.
drawing::Scene friction_fit(const analysis::FrictionFit& fit, std::size_t law);

/// Draws the same of a law over conditions: a colour for the points and the curve of each. Throws `Error` (input) where
/// all were fitted to slips alone.
drawing::Scene friction_over_conditions(const analysis::FrictionOverConditions& over, std::size_t law);

}  // namespace stridor::pictures
