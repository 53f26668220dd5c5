#pragma once

#include "stridor/io/sound/json_sound.hpp"

#include <string>

namespace stridor::console {

/// Are A-weighted levels told of sound pressures alone, or of any unit?
enum class Weighting { of_pressures, of_all };

/// Levels, loudness, peaks, bands and segments of each channel.
std::string analysis_text(const io::SoundReport& report, Weighting weighting);

}  // namespace stridor::console
