#pragma once

#include "stridor/io/simulation/fitted_friction.hpp"
#include "stridor/io/simulation/friction_test.hpp"
#include "stridor/io/simulation/rig_risk.hpp"
#include "stridor/noise_library/sensitivity.hpp"

#include <cstddef>
#include <string>

namespace stridor::console {

/// Returns "0.4213 +- 0.0012"; "-" where it was not measured.
std::string coefficient_text(const analysis::MeasuredCoefficient& coefficient);

/// Returns coefficients and force drops by direction, and what they were measured with.
std::string friction_text(const io::FrictionTest& test, const analysis::FrictionTrace& trace);

/// Returns each law that was fitted, the intervals of the one at this place, and what the data bear.
std::string friction_fit_text(const io::FittedFriction& fitted, std::size_t law);

/// Returns figures, ranks and number of each run, beside the model's category.
std::string risk_text(const io::RigRisk& risk);

/// What the rows of the table are: bins of the quantity, or single records.
enum class SensitivityRows { bins, records };

/// Returns how category, level and frequency move over a quantity: bins or single records, ranges, rank correlations.
std::string sensitivity_text(const noise_library::Sensitivity& result, SensitivityRows rows);

}  // namespace stridor::console
