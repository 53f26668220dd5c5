#pragma once

#include "stridor/sweep/following.hpp"

#include <string>

namespace stridor::console {

/// Returns a motion that was followed as text: stretches of one verdict on the way up and on the way down, and where
/// they differ.
std::string following_text(const sweep::Following& following);

}  // namespace stridor::console
