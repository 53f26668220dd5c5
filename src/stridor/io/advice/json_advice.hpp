#pragma once

#include "stridor/advice/advice.hpp"

#include <string>

namespace stridor::io {

/// "stridor.design/1": the headline of a design, its verdict each way and what lies close to it.
std::string standing_json(const advice::DesignStanding& design);

/// "stridor.advice/1": the headline, the present verdict, the margin of each parameter with its scan, the ranking, the
/// nearest design of the other kind, the verified quieting changes, and the chance of noise within tolerances.
std::string advice_json(const advice::Advice& advice);

}  // namespace stridor::io
