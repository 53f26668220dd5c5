#pragma once

#include "stridor/advice/advice.hpp"

#include <string>

namespace stridor::app {

/// What `stridor advise` prints for people.
std::string advice_text(const advice::Advice& advice);

}  // namespace stridor::app
