#pragma once

#include "stridor/io/sound/json_sound.hpp"

#include <cstddef>
#include <string>

namespace stridor::console {

/// "1 left": how a channel is called.
std::string channel_title(const io::SoundReport& report, std::size_t channel);

/// "0.28 - 0.78 s  squeal ...": the segments of a channel as a table.
std::string segment_table(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

/// The verdict by ear on each channel, its segments, and why each category was heard.
std::string verdict_text(const io::SoundReport& report);

}  // namespace stridor::console
