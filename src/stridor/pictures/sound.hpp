#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/drawing/scene.hpp"
#include "stridor/sound/analysis.hpp"

namespace stridor::pictures {

/// Draws one channel of a recording over time: its waveform, fast level, spectrogram and the category of each segment.
///
/// The spectrogram is drawn up to the frequency below which 99.9 % of the power lies, doubled, and 70 dB down from its
/// strongest cell.
///
/// A channel heard through air also shows the reasons: onsets above its spectrogram, its strongest tone over it, and
/// below it the loudest passage through short frames, in which impulses are vertical lines.
drawing::Scene sound(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

}  // namespace stridor::pictures
