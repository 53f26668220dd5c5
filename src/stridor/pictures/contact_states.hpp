#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <span>
#include <string>

namespace stridor::pictures {

/// One run's contact states with the words above them.
struct StatesOfCase {
    std::string name;  // "squeal"
    parameters::Case c;
    std::vector<record::ContactHistory> histories;  // shape [contact]
};

/// Draws contact states over time, a panel per case, over one stretch of time [s] (Elmaian et al. 2012, Figure 7).
/// Above each panel stand the case's name and parameters.
drawing::Scene contact_states(std::span<const StatesOfCase> cases, const drawing::Extent& time);

/// Returns a panel with the three rows slip, stick and separation for each contact; its x axis is time over a range
/// [s].
drawing::Panel state_panel(std::span<const record::ContactHistory> histories, const drawing::Extent& time);

}  // namespace stridor::pictures
