#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::app {

/// Stability of steady sliding of a case in both directions; with `over` = "key=from:to[:points]"
/// along a parameter, too.
///
/// Throws `Error` (input) for a range that cannot be read, and what `analysis::scan_stability` throws.
analysis::StabilityScan scan_stability(const parameters::Case& c, const std::string& over);

}  // namespace stridor::app
