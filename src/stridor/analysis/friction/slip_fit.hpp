#pragma once

#include "stridor/analysis/friction/fit.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace stridor::analysis {

/// The fewest slips to which laws are fitted.
inline constexpr std::size_t fewest_slips = 8;

/// Fits laws to recorded slips through the model of the rig; docs/methods/friction-fit.md.
///
/// Each slip has a time and a force of its own at which it lets go; the law's shape, and mass and stiffness where they
/// are to be fitted, are those of all. Gauss and Newton's steps (Levenberg 1944, Marquardt 1963) on all samples, those
/// of a slip's own numbers eliminated. Samples of a slip depend on each other, and so do the errors of a model: slips
/// are what is independent. So an interval comes from how much each slip pulls at a number (its influence; Huber 1967,
/// Liang and Zeger 1986), with Student's t. An exponent that is given is the only delta.
FrictionFit fit_of_slips(FrictionPoints data, const MeasuringRig& rig, std::optional<double> exponent = {});

/// Returns the force of the rig's spring in a slip of `fit.data` by a fitted law, both by their places [N], at rising
/// times from its release on [s].
std::vector<double> slip_force(const FrictionFit& fit, std::size_t law, std::size_t slip,
                               std::span<const double> since_release);

}  // namespace stridor::analysis
