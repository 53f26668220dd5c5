#pragma once

#include "stridor/integration/run/motion.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::support {

/// The first figure of a run with a result that contradicts another or is no number, in words; empty if there is none.
///
/// Shares of the time add up to 1, a peak is at least its root mean square, a judged time has levels, the balance of
/// the exact engine closes to 1e-9, there is a phase, and a verdict is made from it.
std::string broken_figure(const parameters::Case& c, const integration::Motion& motion);

/// What is wrong with the run of a case that somebody waits for so long [s] and then stops with Ctrl-C: a broken
/// figure, a refusal that is not the numbers', or no end; empty if nothing is.
std::string complaint_of_run(const parameters::Case& c, double patience_in_seconds);

}  // namespace stridor::support
