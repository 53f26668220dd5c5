#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace stridor::parameters {

/// Where one category ends and the next begins for the ear: thresholds of the figures of a sound, as `Thresholds` are
/// of those of contact states. No part of a case: a recording has none. Reasons and sources: docs/methods/sound.md.
struct SoundThresholds {
    double least_clearness = -14.0;     // [dB] sound over background from which there is anything to judge
    double quiet_depth = 25.0;          // [dB] what lies this far below the loudest stretch is background
    double decay = 7.0;                 // [dB/s] fall of the level from which a sound dies away by itself ...
    double decay_straightness = 0.025;  // [1] ... if at most this share of the fall deviates from a straight line
    double creak_rest = 0.7;            // [1] share of time at rest between impulses from which a sound is `creak`
    double creak_kurtosis = 20.0;       // [1] kurtosis from which its impulses alone make a sound `creak`
    double creak_periodicity = 0.3;     // [1] likeness of the envelope's cycles from which rubbing is `creak`
    double rubbing_tonality = 0.4;      // [1] share of the strongest line below which ...
    double rubbing_repetition = 0.5;    // [1] ... and likeness of cycles below which a sound is mere rubbing
    double least_frequency = 100.0;     // [Hz] a line below it is the rumble of rubbing and no tone
    double squeal_regularity = 0.8;     // [1] likeness of neighbouring cycles from which a tone is `squeal`
    double squeal_repetition = 0.95;    // [1] likeness of the best cycle from which a sound of any lines is `squeal`
    double squeal_movement = 0.12;      // [1] most movement of the strongest frequency in a `squeal`
    double least_impulses = 3.0;        // [1] fewest impulses of a creak; fewer are a knock
    double creak_pause = 1.5;           // [s] longest rest between two impulses of one creak
    double least_duration = 0.05;       // [s] shortest noise that can be judged
    double least_band = 4000.0;         // [Hz] half the rate, below which nothing but a `squeal` can be told
    double majority = 0.5;              // [1] share of the energy that the category of a whole recording must have
    double least_share = 0.2;           // [1] share of a recording's energy from which a noise names it
    double certainty = 0.35;            // [1] probability from which a recording by the ear is decided
};

/// Who asks for a threshold: the rules, which judge motions and forces, or the ear, which judges what is heard through
/// air.
enum class SoundJudge : std::uint8_t { rules, ear, both };

/// One threshold of the table, as `Field` is one parameter of a case.
struct SoundThreshold {
    std::string_view name;      // "squeal_regularity"
    std::string_view unit;      // SI, or "dB", "dB/s"; "1" when dimensionless
    std::string_view sentence;  // what it is, one line
    Range range;
    double SoundThresholds::*member;
    SoundJudge judge = SoundJudge::rules;
};

/// Returns all thresholds by sound, in the order the rules look at them.
std::span<const SoundThreshold> sound_thresholds();

/// Says whether an assignment names a threshold by sound.
bool is_sound_threshold(std::string_view assignment);

/// Sets "squeal_regularity=0.7". Throws `Error` (input) with place "--set" for text without '=', an unknown key (with
/// the nearest known one), and a value that is no number of its unit or out of range.
void set_sound_threshold(SoundThresholds& thresholds, std::string_view assignment);

}  // namespace stridor::parameters
