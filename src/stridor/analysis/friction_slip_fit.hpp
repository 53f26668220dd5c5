#pragma once

#include "stridor/analysis/friction_fit.hpp"

namespace stridor::analysis {

/// The fewest slips to which laws are fitted.
inline constexpr std::size_t fewest_slips = 8;

/// Fits laws to recorded slips through the model of the rig; docs/methods/friction-fit.md.
///
/// Each slip has a time and a force of its own at which it lets go; the law's shape, and mass and stiffness where they
/// are to be fitted, are those of all. Gauss and Newton's steps (Levenberg 1944, Marquardt 1963) on all samples, those
/// of a slip's own numbers eliminated. Samples of a slip depend on each other, and so do the errors of a model: slips
/// are what is independent. So an interval comes from how much each slip pulls at a number (its influence; Huber 1967,
/// Liang and Zeger 1986), with Student's t.
FrictionFit fit_of_slips(FrictionPoints data, const MeasuringRig& rig);

}  // namespace stridor::analysis
