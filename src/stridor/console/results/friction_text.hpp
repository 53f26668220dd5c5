#pragma once

#include "stridor/io/simulation/json_friction.hpp"

#include <string>

namespace stridor::console {

/// "0.4213 +- 0.0012"; "-" where it was not measured.
std::string coefficient_text(const analysis::MeasuredCoefficient& coefficient);

/// Coefficients and force drops by direction, and what they were measured with.
std::string friction_text(const io::FrictionTest& test, const analysis::FrictionTrace& trace);

}  // namespace stridor::console
