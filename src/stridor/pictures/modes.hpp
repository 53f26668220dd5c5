#pragma once

#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"

#include <string>

namespace stridor::pictures {

/// Most modes side by side.
inline constexpr std::size_t most_mode_shapes = 3;

/// Draws the modes of steady sliding that grow, fastest first, each in a column: the motion of the contacts along the
/// surface (real and imaginary part), the growth that each contact adds, and the free modes in it over their frequency
/// (share of energy, and MAC). Only the direction with the faster growth is drawn.
///
/// The scan must have modes (`analysis::with_modes`). Throws `Error` (input) if no motion is free, or if sliding locks
/// both ways.
drawing::Scene mode_shapes(const analysis::StabilityScan& scan);

/// Draws which free modes carry the lines of a spectrum: the level of a velocity over frequency with the free
/// frequencies below it, and for each of its strongest lines the share of each mode in per cent. Modes with less than 5
/// % of every line are drawn together; a mode that works against the others has a negative share.
///
/// `title` names the case, `of` the motion: "bow velocity along x". Throws `Error` (input) for a motion without a line.
drawing::Scene modal_spectrum(const std::string& title, const std::string& of, const analysis::OpenModes& modes,
                              const analysis::ModalSpectrum& spectrum);

}  // namespace stridor::pictures
