#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::console {

/// A case resolved: its fields by section, natural frequencies, what a run of it costs.
std::string case_text(const parameters::Case& c, const integration::Cost& cost);

}  // namespace stridor::console
