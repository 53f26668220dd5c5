#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <functional>

namespace stridor::peers {

/// One of our own engines, with the settings that `set` makes in the case.
std::function<record::ContactHistory(const parameters::Case&)> stridor_engine(void (*set)(parameters::Run&));

}  // namespace stridor::peers
