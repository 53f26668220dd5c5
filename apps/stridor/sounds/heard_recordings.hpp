#pragma once

#include "stridor/classification/sound_verdict.hpp"
#include "stridor/io/sound/expectations.hpp"
#include "stridor/io/sound/hearing_report.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace stridor::app {

/// The verdict by ear on the loudest channel, as `stridor classify` has it; reads the source to its end.
classification::RecordingVerdict verdict_on(signal::Source& source, const parameters::SoundThresholds& thresholds,
                                            const sound::AnalysisProgress& progress = {});

/// Recordings by ear, each kept until all of them are heard; stderr says how far it is and how long it will take.
/// Throws `Error`: interrupted when it is stopped, and what reading a recording throws.
std::vector<io::HeardRecording> heard_recordings(std::span<const io::Expectation> expectations,
                                                 const parameters::SoundThresholds& thresholds,
                                                 const std::stop_token& stop);

}  // namespace stridor::app
