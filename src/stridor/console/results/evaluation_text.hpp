#pragma once

#include "stridor/io/sound/hearing_report.hpp"
#include "stridor/verification/check.hpp"

#include <string>

namespace stridor::console {

/// Returns the tables of an evaluation as people read them.
std::string evaluation_text(const io::HearingReport& report);

/// Returns the head of the table of checks.
std::string check_heading();

/// Returns a row of it: name, expected and computed number, their difference, tolerance, and whether it passes.
std::string check_row(const verification::Check& check);

}  // namespace stridor::console
