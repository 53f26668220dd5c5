#pragma once

#include "stridor/console/command.hpp"

#include <string>

namespace stridor::console {

/// Returns the manual page stridor(1) as man(7) describes it: a section for each command of the program, with all that
/// its help says, and what holds for all of them. Equal for equal versions: there is no date on it.
std::string manual_page(const Command& program, const std::string& version);

}  // namespace stridor::console
