#pragma once

#include "stridor/reduction/reduction_errors.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::reduction {

/// The largest error of a state's frequencies [1], whichever way.
inline double worst_error(const StateErrors& state) {
    double worst = 0.0;
    for (const FrequencyPair& pair : state.frequencies)
        worst = std::max(worst, std::abs(relative_error(pair)));
    return worst;
}

}  // namespace stridor::reduction
