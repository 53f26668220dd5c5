#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/sweep/study.hpp"

#include <string>

namespace stridor::io {

/// Points of an axis whose text says none: as `stridor init noise-chart` has them, and of a diagram over one axis.
inline constexpr int usual_points = 40;
inline constexpr int usual_points_alone = 200;

/// An axis as a command line says it: KEY=FROM:TO, KEY=FROM:TO:POINTS or KEY=FROM:TO:POINTS:SCALE.
///
/// KEY is what `advice::quantity_key_called` understands ("contact.preload", "preload", "F", "joint.lip2.F"). Ends are
/// in its unit or carry one; a unit at the last end alone is that of both ("1:40 N"). The scale is "linear" or "log";
/// without one it is that of the quantity's usual range, or linear where an end has no logarithm. `points` are taken
/// where the text says none.
/// `option` is what messages call it: "--x". Throws `Error` (input).
sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option);

/// The text of an axis, which reads back as the same.
std::string axis_text(const sweep::Axis& axis);

}  // namespace stridor::io
