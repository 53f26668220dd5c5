#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <string>

namespace stridor::peers {

/// CVODE's two families of formulas of variable order.
enum class Formulas {
    adams,
    bdf,  // backward differences, for stiff equations
};

/// SUNDIALS CVODE with its own root finding; `relative` [1] is the tolerance.
record::ContactHistory by_cvode(const parameters::Case& c, double relative, Formulas formulas = Formulas::adams);

std::string cvode_version();

}  // namespace stridor::peers
