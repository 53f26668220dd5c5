#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"

namespace stridor::pictures {

/// Most modes that stand side by side.
inline constexpr std::size_t most_mode_shapes = 3;

/// The modes of steady sliding that grow, fastest first, each in a column: the motion of the contacts along the surface
/// (real and imaginary part), what each contact adds to the growth, and the free modes that it is made of over their
/// frequency (share of energy, and MAC). Of the direction whose modes grow faster.
///
/// The scan has modes (`analysis::with_modes`). Throws `Error` (input) where no motion is left free, or sliding
/// locks both ways.
drawing::Scene mode_shapes(const analysis::StabilityScan& scan);

}  // namespace stridor::pictures
