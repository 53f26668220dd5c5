#pragma once

#include "stridor/advice/advice.hpp"

#include <string>

namespace stridor::io {

/// "stridor.advice/1": the present verdict, the margin of each parameter with its scan, the ranking, the nearest design
/// of the other kind, the verified quieting changes, and the chance of noise within tolerances.
std::string advice_json(const advice::Advice& advice);

}  // namespace stridor::io
