#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <string>

namespace stridor::peers {

/// Boost.odeint: dopri5 with error control and dense output; `relative` [1] is the tolerance.
record::ContactHistory by_odeint(const parameters::Case& c, double relative);

std::string odeint_version();

}  // namespace stridor::peers
