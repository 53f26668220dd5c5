#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/sound/features.hpp"

#include <span>

namespace stridor::classification {

/// Returns the category of a stretch of sound, by these rules in this order:
///
///     clearness < least_clearness                          none    nothing stands out of the background
///     trend <= -decay, along a straight line               none    a free vibration dies away
///     rest >= creak_rest or kurtosis >= creak_kurtosis     creak   impulses with rest between them
///     tonality and repetition below those of rubbing, or frequency < least_frequency:
///         envelope's periodicity >= creak_periodicity      creak   impulses that run into each other
///         otherwise                                        none    rubbing without tone or impulses
///     regularity >= squeal_regularity or repetition >= squeal_repetition,
///         and movement <= squeal_movement                  squeal  a tone, or a sound of many lines, that stays
///     otherwise                                            squeak  a tone that is irregular or moves
///
/// The gain of the sound does not matter. Sources: Elmaian et al. 2012, section 2.1, for what each noise sounds like;
/// docs/methods/sound.md for the figures.
SoundVerdict classify_sound(const sound::SoundFeatures& features, const parameters::SoundThresholds& thresholds);

/// Sets the median of the intervals between impulses and their regularity. `impulses` [s] in time.
void describe_impulses(SoundSegment& segment, std::span<const double> impulses);

/// Returns the segments and the category of a recording from its stretches in time.
///
/// Stretches `quiet_depth` below the loudest are background, hence `none`. Neighbours of one category are one segment.
/// Creaks are counted together if only rest lies between them, with impulses at most `creak_pause` apart. A creak with
/// fewer than `least_impulses` impulses, and a noise shorter than `least_duration`, is `undecided`. The recording has
/// the category with most energy if that is at least `majority` of all; else it is `undecided`.
RecordingVerdict classify_recording(std::span<const sound::SoundStretch> stretches,
                                    const parameters::SoundThresholds& thresholds);

}  // namespace stridor::classification
