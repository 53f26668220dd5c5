#pragma once

#include <string_view>

namespace stridor::base {

/// Returns the program's version, "major.minor.patch".
std::string_view version();

/// Returns the commit from which the program was built, or "unknown" if it was not built from a checkout.
std::string_view commit();

}  // namespace stridor::base
