#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/classification/sound_verdict.hpp"
#include "stridor/signal/sound_analysis.hpp"

namespace stridor::chart {

/// One channel of a recording over time: its waveform, fast level, spectrogram and the category of each segment.
///
/// The spectrogram is drawn up to the frequency below which 99.9 % of the power lies, doubled, and 70 dB down from its
/// strongest cell.
Scene sound(const signal::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

}  // namespace stridor::chart
