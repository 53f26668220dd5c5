#pragma once

#include "stridor/sound/features.hpp"

#include <memory>
#include <span>
#include <vector>

namespace stridor::sound {

/// The longest stretch that is described as one [s].
inline constexpr double longest_stretch = 0.5;

/// Cuts one channel into stretches as its samples come, and describes each. What it keeps grows with a few hundred
/// bytes per half second.
///
/// The sound is cut wherever its sustained level, the median over twelve parts of 5 ms, changes by more than 6 dB, and
/// at the latest after half a second. A median of 60 ms does not see impulses, so they stay in the stretch they belong
/// to; the going and coming phases of a rig fall into stretches of their own.
class StretchFinder {
public:
    /// `rate` [Hz] of the samples.
    explicit StretchFinder(double rate);
    ~StretchFinder();
    StretchFinder(StretchFinder&&) noexcept;
    StretchFinder& operator=(StretchFinder&&) noexcept;

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// Ends the recording: all stretches, in time. A rest too short to be described is left out.
    std::vector<SoundStretch> finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace stridor::sound
