#pragma once

#include "stridor/io/sound/classified_recordings.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/io/sound/signal_report.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace stridor::console {

/// Returns "1 left": how a channel is called.
std::string channel_title(const io::SoundReport& report, std::size_t channel);

/// Returns "0.28 - 0.78 s  squeal ...": the segments of a channel as a table.
std::string segment_table(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

/// Returns the verdict by ear on each channel, its segments, and why each category was heard.
std::string verdict_text(const io::SoundReport& report);

/// Returns "door.wav  creak  0.87  ...": many recordings by ear, a line each, and how many there are of each category.
std::string classified_text(std::span<const io::ClassifiedRecording> rows);

/// Are A-weighted levels told of sound pressures alone, or of any unit?
enum class Weighting { of_pressures, of_all };

/// Returns levels, loudness, peaks, bands and segments of each channel.
std::string analysis_text(const io::SoundReport& report, Weighting weighting);

/// Returns format, rate, duration and channels of a recording, and why each has its unit.
std::string signal_text(const io::SignalSummary& summary);

/// Returns what was made audible of which motion, and how loud it is.
std::string listening_text(const io::SoundInfo& info);

}  // namespace stridor::console
