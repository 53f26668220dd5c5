#pragma once

#include "stridor/analysis/stability_scan.hpp"

#include <string>

namespace stridor::io {

/// Reads "key=from:to[:points]", the ends with units if they have one. Throws `Error` (input) for anything else.
analysis::ScanRange read_scan_range(const std::string& over);

}  // namespace stridor::io
