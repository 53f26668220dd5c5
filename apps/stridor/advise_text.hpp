#pragma once

#include "stridor/sweep/advice.hpp"

#include <string>

namespace stridor::app {

/// What `stridor advise` prints for people.
std::string advice_text(const sweep::Advice& advice);

}  // namespace stridor::app
