#pragma once

#include "stridor/advice/advice.hpp"

#include <string>

namespace stridor::console {

/// Returns what `stridor advise` prints for people.
std::string advice_text(const advice::Advice& advice);

}  // namespace stridor::console
