#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/noise_library/sensitivity.hpp"

namespace stridor::pictures {

/// Category, level and dominant frequency of each record over a quantity, in panels above each other; a panel for which
/// no record has a figure is left out. Each category has its colour and its mark.
drawing::Scene sensitivity(const noise_library::Sensitivity& sensitivity);

}  // namespace stridor::pictures
