#pragma once

#include "stridor/io/sound/hearing_report.hpp"

#include <string>

namespace stridor::console {

/// The tables of an evaluation as people read them.
std::string evaluation_text(const io::HearingReport& report);

}  // namespace stridor::console
