#pragma once

#include <string_view>

namespace stridor::base {

/// Program version, "major.minor.patch".
std::string_view version();

/// Commit the program was built from, or "unknown" when it was not built from a checkout.
std::string_view commit();

}  // namespace stridor::base
