#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/sound/features.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace stridor::classification {

/// The sound of a whole recording: one number per figure.
///
/// Each figure of `features` is the median over the recording's stretches, weighted by their energy; stretches more
/// than `quiet_depth` below the loudest are background and do not count. `features.mean_square` is the mean over them,
/// `features.peak` the greatest, `features.from` the beginning of the first and `features.duration` their sum.
struct SoundProfile {
    sound::SoundFeatures features{};
    double impulse_interval = 0.0;    // [s] of the creak's impulses, else of the envelope; 0: nothing repeats
    double impulse_regularity = 0.0;  // [1] of neighbouring intervals, else the envelope's periodicity
};

/// Says whether the recording is silent.
inline bool is_silent(const SoundProfile& profile) {
    return !(profile.features.mean_square > 0.0);
}

/// Returns the profile of a recording from its stretches and the verdict on them; a silent one without stretches.
SoundProfile profile_of(std::span<const sound::SoundStretch> stretches, const RecordingVerdict& verdict,
                        const parameters::SoundThresholds& thresholds);

/// How a figure of two sounds is compared.
enum class FigureScale { linear, octaves };

/// One figure by which sounds are compared.
struct LikenessFigure {
    std::string_view name;                         // as in the table of figures, "tonality"
    std::string_view unit;                         // of `value`
    std::string_view sentence;                     // what it is, one line
    FigureScale scale = FigureScale::linear;       // octaves: the difference of base-2 logarithms
    double step = 1.0;                             // [unit], [octave] the difference that counts as one
    double weight = 1.0;                           // [1]
    double (*value)(const SoundProfile&);          // [unit]
    double (*sureness)(const SoundProfile&) = {};  // [1] from 0 to 1, how much the figure means; null: always 1
};

/// Returns all figures but the level, in a fixed order. docs/methods/likeness.md explains steps and weights.
std::span<const LikenessFigure> likeness_figures();

/// A difference beyond this many steps counts as this many: one figure alone never decides.
inline constexpr double most_steps = 4.0;

/// Whether a difference of level counts. It does only if both sounds have one unit and are calibrated.
enum class LevelUse { ignored, counted };

/// One figure of two sounds.
struct FigureDifference {
    std::string_view name;
    std::string_view unit;
    double first = 0.0;   // [unit]
    double second = 0.0;  // [unit]
    double steps = 0.0;   // [1] second - first, at most `most_steps` either way
    double share = 0.0;   // [1] of the squared distance; 0 for all where the distance is 0
};

/// The distance of two sounds from each other.
struct Likeness {
    double distance = 0.0;                        // [1] 0: alike in every figure; at most `most_steps`
    std::vector<FigureDifference> differences{};  // greatest share first; empty if either sound is silent
};

/// Returns the distance of two sounds,
///
///     d² = Σ wᵢ sᵢ min(|xᵢ - yᵢ| / hᵢ, 4)² / Σ wᵢ
///
/// over the figures x, y with step h and weight w, sᵢ² being the product of both figures' sureness. It is symmetric, 0
/// between a sound and itself, and does not depend on gain while the level is ignored. Two silences are alike; silence
/// is 4 from every sound. The weights are Stridor's own, not a measured annoyance.
Likeness likeness(const SoundProfile& first, const SoundProfile& second, LevelUse level = LevelUse::ignored);

}  // namespace stridor::classification
