#pragma once

#include "stridor/hearing/live_ear.hpp"
#include "stridor/io/sound/live_events.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace stridor::console {

/// Returns "  12.000 -   15.000 s  creak   0.87   -32.1 dB re FS   1042 Hz  channel 2": a noisy passage as it is heard.
std::string live_passage_line(const hearing::LivePassage& passage, const io::LiveInput& input);

/// Returns "noise 3: creak, 12.000 to 18.500 s, kept in clips/noise-....wav".
std::string live_noise_line(const hearing::LiveNoise& noise, const io::KeptClip& kept);

/// Returns "gap at 33.200 s: 0.012 s are missing (overrun)".
std::string live_gap_line(const io::LiveGap& gap);

/// Returns "heard 600.000 s in 1 take, 3 noises, 0 gaps: the input ended".
std::string live_sum_line(const io::LiveSum& sum);

/// Returns what a live ear hears now, as lines of a terminal that is `columns` wide: what is listened to, and for each
/// channel its level, the course of the last minute, and under them what it is now, by a guess, and the first letters
/// of the noises: l squeal, k squeak, c creak.
std::string live_block(const io::LiveInput& input, std::span<const hearing::LiveCourse> courses, const io::LiveSum& sum,
                       std::size_t columns);

}  // namespace stridor::console
