#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/noise_library/sensitivity.hpp"

namespace stridor::pictures {

/// Draws category, level and dominant frequency of each record over a quantity, in panels above each other; a panel is
/// left out if no record has its figure. Each category has its colour and its mark.
drawing::Scene sensitivity(const noise_library::Sensitivity& sensitivity);

}  // namespace stridor::pictures
