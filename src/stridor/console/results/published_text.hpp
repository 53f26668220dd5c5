#pragma once

#include "stridor/verification/published.hpp"

#include <string>

namespace stridor::console {

/// Returns the head of the table of published results.
std::string published_heading();

/// Returns a system of it: where it was read, its case, what was assumed, and a row for each number.
std::string published_text(const verification::HeldSystem& system);

/// Returns what was not reproduced, with the reason below it.
std::string not_reproduced_text();

}  // namespace stridor::console
