#pragma once

#include "stridor/sweep/study.hpp"

#include <string_view>
#include <utility>

/// The chart around a case of which nobody named the axes: that of a report, and the first one of the page.
namespace stridor::sweep {

/// The axis of a quantity over its usual range around a case (`parameters::usual_range`, which it must have). The
/// kinetic friction ends at the static one, the velocity is a magnitude.
Axis usual_axis(const parameters::Case& c, std::string_view key, int points);

/// Preload, or stiffness where a load or gaps press, over kinetic friction, or the temperature that it follows; where a
/// case has one of them only, with what else presses or moves it.
std::pair<Axis, Axis> usual_axes(const parameters::Case& c, int points);

}  // namespace stridor::sweep
