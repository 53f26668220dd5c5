#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <string>

namespace stridor::peers {

/// SUNDIALS CVODE: Adams formulas with its own root finding; `relative` [1] is the tolerance.
record::ContactHistory by_cvode(const parameters::Case& c, double relative);

std::string cvode_version();

}  // namespace stridor::peers
