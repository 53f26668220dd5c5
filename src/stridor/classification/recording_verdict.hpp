#pragma once

#include "stridor/classification/sound_verdict.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>

namespace stridor::classification {

/// The segments and the category of a recording by the ear, from its stretches and passages in time.
///
/// Each passage is heard by itself. Passages `quiet_depth` below the loudest are background, hence `none`. The
/// recording is the noise with most of the A-weighted energy, if that is `least_share` of all; what is less is over
/// rubbing, or beside another noise. Its probability is the mean over the passages it was heard in, weighted by their
/// energy; below `certainty` the recording is `undecided`. A segment is what of such a passage lies within
/// `segment_depth` of its loudest stretch.
RecordingVerdict classify_passages(std::span<const sound::SoundStretch> stretches,
                                   std::span<const sound::Passage> passages,
                                   const parameters::SoundThresholds& thresholds);

/// The verdict on one channel: by the ear where it has passages, as those of microphones have, and by the rules of
/// `classify_recording` where it is a motion. What is sampled below `least_band` is a squeal or undecided.
RecordingVerdict verdict_on(const sound::SoundAnalysis& channel, const parameters::SoundThresholds& thresholds);

}  // namespace stridor::classification
