#pragma once

#include "stridor/analysis/stability_path.hpp"
#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"

#include <span>
#include <string_view>

namespace stridor::pictures {

/// The stability of steady sliding in one direction, followed along a quantity.
struct StabilityCurve {
    parameters::Direction direction = parameters::Direction::going;
    analysis::StabilityPath path;
};

/// Frequencies and growth rates of the sliding modes over a quantity of the field table ("contact.kinetic_friction"), a
/// column per direction: where two frequencies meet and one growth rate turns positive, modes couple. The ground
/// under unstable sliding is tinted and the path's boundaries are named.
drawing::Scene stability(std::string_view quantity, std::span<const StabilityCurve> curves);

}  // namespace stridor::pictures
