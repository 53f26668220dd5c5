#pragma once

#include "stridor/analysis/friction/fit.hpp"

#include <optional>

namespace stridor::analysis {

/// Fits laws to runs of steady sliding and to slips at once; docs/methods/friction-fit.md.
///
/// The slips are fitted first, through the model of the rig (`fit_of_slips`). What they say of a law is its numbers
/// with their covariance; a law of both has the least sum of squares of the steady points over their variance, and of
/// its distance from these numbers over that covariance. An exponent that is given is the only delta. The laws have
/// neither rows nor k_v, which slips do not show.
FrictionFit fit_of_both(FrictionPoints data, const MeasuringRig& rig, std::optional<double> exponent = {});

}  // namespace stridor::analysis
