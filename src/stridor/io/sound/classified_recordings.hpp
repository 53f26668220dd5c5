#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Many recordings by ear, a row each.
namespace stridor::io {

/// What a channel is that is heard as another category than the one the verdict rests on.
struct DifferingChannel {
    std::size_t channel = 0;  // [1] from 1
    classification::Category category = classification::Category::undecided;
    double probability = 0.0;      // [1] by the ear; 0: by rules
    std::optional<double> softer;  // [dB] than that one, where the units are the same
};

/// A recording in a row of many: the verdict on it, or why nothing could be heard.
struct ClassifiedRecording {
    std::string file;
    std::string refusal{};  // why it could not be heard; empty: it was heard, and what follows holds
    classification::Category category = classification::Category::undecided;
    double probability = 0.0;                                            // [1] of the category, by the ear; 0: by rules
    std::array<double, classification::category_names.size()> shares{};  // [1] of the energy, by category
    std::size_t channel = 0;                                             // [1] that the verdict rests on, from 1
    std::size_t channels = 0;                                            // [1] of the recording
    double duration = 0.0;                                               // [s]
    double rate = 0.0;                                                   // [Hz]
    double level = 0.0;                                                  // [level_unit] of the channel, mean
    std::string level_unit{};                                            // "dB re 20 uPa"
    double frequency = 0.0;  // [Hz] dominant, of the category's loudest segment; NaN if there is none
    std::vector<DifferingChannel> others{};
    std::vector<std::string> reasons{};
    std::vector<std::string> notes{};  // how it was read, where that is not as usual
};

/// Returns the channels that are heard as another category than the one the verdict rests on.
std::vector<DifferingChannel> differing_channels(const SoundReport& report);

/// Returns what is said of a channel: "channel 2 is creak, probability 0.74, 1.4 dB softer".
std::string sentence_of(const DifferingChannel& other);

/// Returns the row of a recording that was heard; it is called `file`. What the other channels are stands behind the
/// reasons where they differ.
ClassifiedRecording classified(const std::string& file, const SoundReport& report);

/// Returns "stridor.classified/1": a member of `recordings` per row, `error` in place of the verdict where nothing
/// could be heard; thresholds and units.
std::string classified_json(std::span<const ClassifiedRecording> rows, const parameters::SoundThresholds& thresholds);

/// Returns "stridor.classified/1" as a table: a row per recording; where nothing could be heard all is empty but `file`
/// and `error`. Thresholds other than the usual ones stand in its first line.
std::string classified_csv(std::span<const ClassifiedRecording> rows, const parameters::SoundThresholds& thresholds);

}  // namespace stridor::io
