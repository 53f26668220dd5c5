#pragma once

#include "stridor/analysis/stability_path.hpp"
#include "stridor/io/json.hpp"
#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::app {

/// Stability of steady sliding of a case in both directions; with `over` = "key=from:to[:points]" along a parameter, too.
///
/// Static friction plays no part in it, so mu_d may be followed beyond mu_s. Throws `Error` (input) for a range that
/// cannot be read or whose ends lie outside the parameter's.
io::StabilityScan scan_stability(const parameters::Case& c, const std::string& over);

}  // namespace stridor::app
