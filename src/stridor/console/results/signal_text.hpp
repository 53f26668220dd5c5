#pragma once

#include "stridor/io/sound/signal_report.hpp"

#include <string>

namespace stridor::console {

/// Format, rate, duration and channels of a recording, and why each has its unit.
std::string signal_text(const io::SignalSummary& summary);

}  // namespace stridor::console
