#pragma once

#include "stridor/classification/ear.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/sound/features.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace stridor::classification {

/// The category of a sound with the figures it was made from, how far each lies from its threshold, and why.
struct SoundVerdict {
    Category category = Category::undecided;
    sound::SoundFeatures features{};
    std::vector<Margin> margins{};       // in the order the rules look at them; those never reached are listed too
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

/// A passage of a recording by the ear.
struct HeardPassage {
    double from = 0.0;    // [s]
    double to = 0.0;      // [s]
    double energy = 0.0;  // [unit² s] A-weighted
    Category category = Category::none;
    EarVerdict ear{};
};

/// A recording: its segments, and its category. By the rules that is the one with most of the energy; by the ear, the
/// strongest noise.
struct RecordingVerdict {
    Category category = Category::undecided;
    double probability = 0.0;                            // [1] of the category, by the ear; 0: the rules know none
    std::vector<HeardPassage> passages{};                // by the ear, in time; none by the rules
    std::array<double, category_names.size()> shares{};  // [1] of the energy, by category
    std::vector<SoundSegment> segments{};                // one after the other, in time
    std::vector<std::string> reasons{};
    /// The loudest segment of the recording's category; null where there is none.
    const SoundSegment* loudest() const;
};

/// The segments and the category of a recording by the ear, from its stretches and passages in time.
///
/// Each passage is heard by itself. Passages `quiet_depth` below the loudest are background, hence `none`. The
/// recording is the noise with most of the A-weighted energy, if that is `least_share` of all; what is less is over
/// rubbing, or beside another noise. Its probability is the mean over the passages it was heard in, weighted by their
/// energy; below `certainty` the recording is `undecided`. A segment is what of such a passage lies within
/// `segment_depth` of its loudest stretch.
RecordingVerdict classify_passages(std::span<const sound::SoundStretch> stretches,
                                   std::span<const sound::Passage> passages,
                                   const parameters::SoundThresholds& thresholds);

/// The verdict on one channel: by the ear where it has passages, as those of microphones have, and by the rules of
/// `classify_recording` where it is a motion. What is sampled below `least_band` is a squeal or undecided.
RecordingVerdict verdict_on(const sound::SoundAnalysis& channel, const parameters::SoundThresholds& thresholds);

}  // namespace stridor::classification
