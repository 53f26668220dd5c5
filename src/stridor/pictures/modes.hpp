#pragma once

#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"

#include <string>

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

/// Which free modes carry the lines of a spectrum: the level of a velocity over frequency with the free frequencies
/// below it, and for each of its strongest lines the share of each mode in per cent. Modes with less than 5 % of every
/// line are drawn together; a mode that works against the others has a negative share.
///
/// `title` names the case, `of` the motion: "bow velocity along x". Throws `Error` (input) for a motion without a line.
drawing::Scene modal_spectrum(const std::string& title, const std::string& of, const analysis::OpenModes& modes,
                              const analysis::ModalSpectrum& spectrum);

}  // namespace stridor::pictures
