#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/drawing/scene.hpp"

#include <span>

namespace stridor::pictures {

/// Draws sounds side by side, a column each: time history, spectrogram, category by ear, a short stretch wave by wave,
/// the contact states in it if a simulation knows them, and figures (Elmaian et al. 2012, Figure 4).
///
/// Every sound is drawn on its own scale of amplitude and its own time axis, all on one frequency axis; the colours of
/// a spectrogram are levels below its own strongest cell. So shapes compare, and loudness does not.
drawing::Scene side_by_side(std::span<const classification::ComparedSound> sounds);

}  // namespace stridor::pictures
