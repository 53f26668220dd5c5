#pragma once

#include "stridor/classification/sound_verdict.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/sound/analysis.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stridor::io {

/// What was found in a recording: one analysis and one verdict per channel.
struct SoundReport {
    std::string file;
    std::string format;
    std::vector<std::string> notes{};
    parameters::SoundThresholds thresholds{};
    std::vector<sound::SoundAnalysis> channels{};
    std::vector<classification::RecordingVerdict> verdicts{};  // shape [channel]
    std::size_t loudest = 0;  // the channel with the greatest level, whose verdict is the recording's
};

/// "stridor.classify/1": category of the recording and of each channel, its shares, and each segment with figures,
/// margins and reasons; thresholds and units.
std::string classify_json(const SoundReport& report);

/// "stridor.analyse/1": levels, spectrum, peaks, octave, third-octave and named bands and segments per channel.
std::string analyse_json(const SoundReport& report);

}  // namespace stridor::io
