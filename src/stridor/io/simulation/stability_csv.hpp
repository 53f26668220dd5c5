#pragma once

#include "stridor/analysis/stability_scan.hpp"

#include <string>

namespace stridor::io {

/// Writes "stridor.modes/1", a row per mode of steady sliding: direction, the value of the parameter where one was
/// followed, what sliding is there, frequency, growth, damping ratio, and whether the mode grows. Where sliding locks
/// or leaves no motion a row says so without a mode.
std::string stability_csv(const analysis::StabilityScan& scan);

}  // namespace stridor::io
