#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/cell.hpp"

#include <span>

namespace stridor::pictures {

/// Slip, stick and separation rate over the two axes of sweeps, a row of three maps per sweep and direction (Elmaian et
/// al. 2012, Figure 6: two incidence angles). Cells without a result are white and crossed.
drawing::Scene rate_map(std::span<const sweep::SweepResult> results);

}  // namespace stridor::pictures
