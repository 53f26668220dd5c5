#pragma once

#include "stridor/analysis/modal_spectrum.hpp"
#include "stridor/drawing/scene.hpp"

#include <string>

namespace stridor::pictures {

/// Which free modes carry the lines of a spectrum: the level of a velocity over frequency with the free frequencies
/// below it, and for each of its strongest lines the share of each mode in per cent. Modes with less than 5 % of every
/// line are drawn together; a mode that works against the others has a negative share.
///
/// `title` names the case, `of` the motion: "bow velocity along x". Throws `Error` (input) for a motion without a line.
drawing::Scene modal_spectrum(const std::string& title, const std::string& of, const analysis::OpenModes& modes,
                              const analysis::ModalSpectrum& spectrum);

}  // namespace stridor::pictures
