#pragma once

#include "stridor/analysis/stability_scan.hpp"

#include <string>

namespace stridor::console {

/// Modes of steady sliding in both directions; along a parameter its boundaries and a table, too.
std::string stability_text(const analysis::StabilityScan& scan);

}  // namespace stridor::console
