#pragma once

#include "stridor/verification/check.hpp"

#include <string>

namespace stridor::console {

/// The head of the table of checks, and a row of it.
std::string check_heading();
std::string check_row(const verification::Check& check);

}  // namespace stridor::console
