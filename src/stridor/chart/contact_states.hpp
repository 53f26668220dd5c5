#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/contact_history.hpp"

#include <span>
#include <string>

namespace stridor::chart {

/// One run's contact states with the words above them.
struct StatesOfCase {
    std::string name;  // "squeal"
    parameters::Case c;
    record::ContactHistory history;
};

/// Contact states over time, a panel per case, over one stretch of time [s] (Elmaian et al. 2012, Figure 7). Above each
/// panel stand the case's name and parameters.
Scene contact_states(std::span<const StatesOfCase> cases, const Range& time);

/// A panel with the three rows slip, stick and separation; its x axis is time over a range [s].
Panel state_panel(const record::ContactHistory& history, const Range& time);

}  // namespace stridor::chart
