#pragma once

#include "stridor/sound/features.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace stridor::sound {

/// One feature of a sound. Documents, evaluations, entries of the noise library and the files of a search take their
/// lists of features from this table; docs/methods/sound.md has the formulas.
struct SoundFeature {
    std::string_view name;  // "tonality"
    std::string_view unit;  // "1" when dimensionless
    double SoundFeatures::*member;

    /// Where a feature is told besides the documents about a sound, which hold all: in evaluations of the rules, and in
    /// entries of the noise library. Entries call the tone "dominant_frequency" and count the impulses of the whole
    /// segment.
    enum class Told : std::uint8_t { everywhere, in_evaluations, in_entries } told = Told::everywhere;
};

/// All features of a sound, in the order of documents. `from`, `duration`, `mean_square` and `peak` say which sound it
/// is and how loud, and `impulses` is a count: these are written separately.
inline constexpr std::array feature_table{
    SoundFeature{"clearness", "dB", &SoundFeatures::clearness},
    SoundFeature{"frequency", "Hz", &SoundFeatures::frequency, SoundFeature::Told::in_evaluations},
    SoundFeature{"prominence", "dB", &SoundFeatures::prominence, SoundFeature::Told::in_entries},
    SoundFeature{"tonality", "1", &SoundFeatures::tonality},
    SoundFeature{"regularity", "1", &SoundFeatures::regularity},
    SoundFeature{"repetition", "1", &SoundFeatures::repetition},
    SoundFeature{"repetition_frequency", "Hz", &SoundFeatures::repetition_frequency,
                 SoundFeature::Told::in_evaluations},
    SoundFeature{"movement", "1", &SoundFeatures::movement},
    SoundFeature{"trend", "dB/s", &SoundFeatures::trend, SoundFeature::Told::in_evaluations},
    SoundFeature{"unsteadiness", "dB", &SoundFeatures::unsteadiness},
    SoundFeature{"abruptness", "dB", &SoundFeatures::abruptness, SoundFeature::Told::in_entries},
    SoundFeature{"rest", "1", &SoundFeatures::rest},
    SoundFeature{"kurtosis", "1", &SoundFeatures::kurtosis},
    SoundFeature{"crest", "1", &SoundFeatures::crest, SoundFeature::Told::in_entries},
    SoundFeature{"impulse_interval", "s", &SoundFeatures::impulse_interval, SoundFeature::Told::in_evaluations},
    SoundFeature{"impulse_periodicity", "1", &SoundFeatures::impulse_periodicity, SoundFeature::Told::in_evaluations},
};

// four numbers and a count, which has the place of a number, are not in it; a feature that is added is
static_assert(sizeof(SoundFeatures) == (5 + feature_table.size()) * sizeof(double));

/// Returns the row of a member, for tables that describe it in other words.
constexpr const SoundFeature& feature_of(double SoundFeatures::*member) {
    std::size_t place = 0;
    while (feature_table[place].member != member)
        ++place;
    return feature_table[place];
}

}  // namespace stridor::sound
