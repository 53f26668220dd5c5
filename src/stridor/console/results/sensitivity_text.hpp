#pragma once

#include "stridor/noise_library/sensitivity.hpp"

#include <string>

namespace stridor::console {

/// What the rows of the table are: bins of the quantity, or single records.
enum class SensitivityRows { bins, records };

/// How category, level and frequency move over a quantity: bins or single records, ranges, rank correlations.
std::string sensitivity_text(const noise_library::Sensitivity& result, SensitivityRows rows);

}  // namespace stridor::console
