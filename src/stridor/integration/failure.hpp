#pragma once

#include "stridor/base/error.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/parameters/case.hpp"

#include <optional>

namespace stridor::integration {

/// Returns why a run has no result, and what to do about it, as every command and every cell of a chart says it;
/// nothing for a run that has one.
///
/// Its kind is numerical, but input for a step beyond the limit and interrupted for a run that was stopped.
std::optional<Error> failure(const parameters::Case& c, const Motion& motion);

/// Returns the error of a step beyond the stability limit, which is known before the run (`cost`).
Error beyond_step_limit(const parameters::Case& c);

}  // namespace stridor::integration
