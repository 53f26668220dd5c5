#pragma once

#include "stridor/hearing/live_ear.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/signal/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// What a live ear tells: "stridor.listen-in/1", a JSON document per line and event.
namespace stridor::io {

/// A sound that is not over.
struct LiveInput {
    std::string name;    // of the device, the file; "standard input"
    std::string format;  // "WAV, 24 bit, 48000 Hz, 4 channels"
    signal::ChannelLayout layout{};
};

/// What was lost of a sound.
struct LiveGap {
    double at = 0.0;                  // [s] of the sound that was heard
    std::optional<double> seconds{};  // [s] that are missing, if anybody knows
    std::string why{};                // "arecord: overrun!!! (at least 12.345 ms long)"
};

/// What became of the clip of a noise.
struct KeptClip {
    std::string file{};      // empty: none was kept
    std::int64_t entry = 0;  // of the noise library; 0: none
    std::string failure{};   // why it could not be kept
};

/// What was heard altogether.
struct LiveSum {
    double heard = 0.0;  // [s]
    std::size_t takes = 0;
    std::size_t noises = 0;
    std::size_t gaps = 0;
    std::string why{};  // it is over: "the input ended"
};

/// Returns seconds since 1970 as "2026-11-27T15:42:25.123Z".
std::string stamp_text(double seconds);

/// Returns the seconds since 1970 of "2026-11-27T15:42:25Z", with or without parts of a second. Throws `Error` (input)
/// for another text.
double seconds_of_stamp(const std::string& text);

/// Returns the report that `classify` gives of a recording of the take's samples.
SoundReport report_of(hearing::LiveTake take, const LiveInput& input, const parameters::SoundThresholds& thresholds);

// each a line, without its end; `begin` [s since 1970] is when the sound began that stands at 0 s

std::string begin_event(const LiveInput& input, double begin);
std::string passage_event(const hearing::LivePassage& passage, const LiveInput& input, double begin);
std::string noise_event(const hearing::LiveNoise& noise, const LiveInput& input, const KeptClip& kept, double begin);
std::string gap_event(const LiveGap& gap, double begin);
std::string take_event(const hearing::LiveTake& take, const SoundReport& report, double begin);
std::string end_event(const LiveSum& sum, double begin);

/// Returns the word for the end of a take: "gap", "full", "end".
std::string_view take_end_name(hearing::TakeEnd why);

}  // namespace stridor::io
