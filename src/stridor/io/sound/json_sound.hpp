#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/sound/analysis.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// Returns "stridor.classify/1": category of the recording and of each channel, its shares, and each segment with
/// figures, margins and reasons; thresholds and units.
std::string classify_json(const SoundReport& report);

/// Returns "stridor.analyse/1": levels, spectrum, peaks, octave, third-octave and named bands and segments per channel.
std::string analyse_json(const SoundReport& report);

// The verdict by ear as the noise library keeps it.

/// So many segments of a recording are kept, the loudest: hours of creaking fill no library.
inline constexpr std::size_t most_kept_segments = 200;

/// Returns "stridor.verdict/1": who judged, by which thresholds, and the verdict of the report's loudest channel, whose
/// number in the file is `channel`, from 1; with the figures that went into the entry beside it.
std::string verdict_json(const SoundReport& report, std::size_t channel,
                         std::span<const noise_library::Figure> figures);

/// What must be known of a verdict before another takes its place.
struct KeptVerdict {
    bool is_current = false;                       // this very program judged
    std::size_t channel = 0;                       // of the file, from 1; 0: unknown
    std::vector<noise_library::Figure> figures{};  // without units
};

/// Reads it back; nothing for what is no such verdict.
std::optional<KeptVerdict> kept_verdict(std::string_view text);

/// Returns an entry without its verdict: without the category, and without the figures that the verdict brought, unless
/// they were changed since.
noise_library::Entry without_verdict(noise_library::Entry entry);

}  // namespace stridor::io
