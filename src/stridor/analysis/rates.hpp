#pragma once

#include "stridor/model/contact_state.hpp"

#include <array>

namespace stridor::analysis {

/// Contact-state rates: the share of a window spent in each state, adding up to 1 (Elmaian et al. 2012, section 3.1).
struct Rates {
    double slip = 0.0;        // [1]
    double stick = 0.0;       // [1]
    double separation = 0.0;  // [1]
};

/// Shares of the total of times spent in each state [s]; all NaN where no time was counted.
Rates rates(const std::array<double, model::contact_states>& time);

}  // namespace stridor::analysis
