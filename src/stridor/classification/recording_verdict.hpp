#pragma once

#include "stridor/classification/ear.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/sound/features.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace stridor::classification {

/// The category of a sound with its figures, the distance of each from its threshold, and the reasons.
struct SoundVerdict {
    Category category = Category::undecided;
    sound::SoundFeatures features{};
    std::vector<Margin> margins{};       // in the order of the rules; those never reached are listed too
    std::vector<std::string> reasons{};  // sentences, in the order of the rules
};

/// A part of a recording that is of one category throughout. Its figures are those of its loudest stretch.
struct SoundSegment {
    double from = 0.0;               // [s]
    double to = 0.0;                 // [s]
    double mean_square = 0.0;        // [unit²] of its sound
    std::vector<double> impulses{};  // [s] instants in the recording, if it is a creak
    double impulse_interval = 0.0;   // [s] median of the times between them; 0: fewer than two
    double impulse_regularity =
        0.0;  // [1] 1 - mean difference of neighbouring intervals over the mean interval, at least 0
    SoundVerdict verdict{};
};

/// The ear's verdict on a passage of a recording.
struct HeardPassage {
    double from = 0.0;    // [s]
    double to = 0.0;      // [s]
    double energy = 0.0;  // [unit² s] A-weighted
    Category category = Category::none;
    EarVerdict ear{};
};

/// The verdict on a recording: its segments and its category. By the rules that is the category with most of the
/// energy, by the ear the strongest noise.
struct RecordingVerdict {
    Category category = Category::undecided;
    double probability = 0.0;                            // [1] of the category, by the ear; 0: by the rules
    std::vector<HeardPassage> passages{};                // by the ear, in time; empty by the rules
    std::array<double, category_names.size()> shares{};  // [1] of the energy, by category
    std::vector<SoundSegment> segments{};                // one after the other, in time
    std::vector<std::string> reasons{};
    /// Returns the loudest segment of the recording's category, or null if there is none.
    const SoundSegment* loudest() const;
};

/// Returns the segments and the category of a recording by the ear, from its stretches and passages in time.
///
/// Each passage is heard by itself. Passages `quiet_depth` below the loudest are background, hence `none`. The
/// recording is the noise with most of the A-weighted energy if that is at least `least_share` of all energy; a smaller
/// share is over rubbing, or beside another noise. Its probability is the mean over the passages in which it was heard,
/// weighted by their energy; below `certainty` the recording is `undecided`. A segment is the part of such a passage
/// that lies within `segment_depth` of its loudest stretch.
RecordingVerdict classify_passages(std::span<const sound::SoundStretch> stretches,
                                   std::span<const sound::Passage> passages,
                                   const parameters::SoundThresholds& thresholds);

/// Returns the verdict on one channel: by the ear if it has passages, as a microphone's channel has, and by the rules
/// of `classify_recording` if it is a motion. A channel sampled below `least_band` is a squeal or undecided.
RecordingVerdict verdict_on(const sound::SoundAnalysis& channel, const parameters::SoundThresholds& thresholds);

}  // namespace stridor::classification
