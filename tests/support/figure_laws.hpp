#pragma once

#include "stridor/integration/motion.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::support {

/// The first figure of a run with a result that contradicts another or is no number, in words; empty if there is none.
///
/// Shares of the time add up to 1, a peak is at least its root mean square, a judged time has levels, the balance of the exact
/// engine closes to 1e-9, there is a phase, and a verdict is made from it.
std::string broken_figure(const parameters::Case& c, const integration::Motion& motion);

}  // namespace stridor::support
