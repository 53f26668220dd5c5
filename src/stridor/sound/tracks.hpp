#pragma once

#include "stridor/sound/analysis.hpp"

#include <cstddef>
#include <vector>

/// The course of a channel by its passages, thinned to what a picture can show.
namespace stridor::sound {

/// Returns the strongest tone over time, while the fast level lies within 20 dB of its greatest: a pitch that is hardly
/// audible explains nothing. At most `most` points, one in each of as many equal moments, with the median frequency
/// there.
std::vector<TonePoint> pitch_track(const SoundAnalysis& channel, std::size_t most);

/// Returns the instants of the onsets [s]: at most `most`, the first in each of as many equal moments.
std::vector<double> onset_track(const SoundAnalysis& channel, std::size_t most);

}  // namespace stridor::sound
