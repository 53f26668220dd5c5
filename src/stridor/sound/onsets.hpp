#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The course of a passage: how its level steps up and falls off above 1 kHz, where the impulses of a creak rise above
/// the ringing of the room and the wood. Formulas: docs/methods/ear.md.
struct Onsets {
    std::vector<double> instants{};   // [s] of steps up by 4.5 dB or more
    double rate = 0.0;                // [1/s] of them, while the sound lasts
    double skewness = 0.0;            // [1] of the steps over 4 or 8 ms, the greater: positive where the level rises
                                      // faster than it falls
    double train = 0.0;               // [1] share of the time that rows of onsets take whose intervals change little
    double longest_train = 0.0;       // [1] onsets in the longest row
    double fast_rate = 0.0;           // [1/s] of steps up over 2 ms, while the sound lasts
    double fast_skewness = 0.0;       // [1] `skewness` of these steps
    double fast_train = 0.0;          // [1] share of the time that rows of eight of them take, at most 60 ms apart
    double longest_fast_train = 0.0;  // [1] of them in the longest such row
    double joint_skewness = 0.0;      // [1] `skewness` of the mean level of octaves, see `octave_levels`
    double joint_train = 0.0;         // [1] onsets in the longest row of that level
    double beat = 0.0;                // [dB] standard deviation of the level over 8 ms around that over 0.2 s
    double rhythm = 0.0;              // [dB] see `rhythm_of`, above 1 kHz
    double kurtosis = 0.0;            // [1] above 1 kHz: sine 1.5, noise 3, impulses more; 0: silence
    double level_spread = 0.0;        // [dB] standard deviation of the level over 50 ms, above 100 Hz
    double sounding = 0.0;            // [1] share of the time within 20 dB of the greatest of those levels,
                                      // from the first to the last such moment
};

/// Returns the onsets of a passage, at least 20 ms long; `rate` [Hz] of the samples.
Onsets onsets_of(std::span<const double> samples, double rate);

}  // namespace stridor::sound
