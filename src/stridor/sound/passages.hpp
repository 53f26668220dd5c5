#pragma once

#include "stridor/signal/spectrogram.hpp"
#include "stridor/sound/features.hpp"
#include "stridor/sound/onsets.hpp"
#include "stridor/sound/part_squares.hpp"
#include "stridor/sound/tones.hpp"

#include <memory>
#include <span>
#include <vector>

namespace stridor::sound {

/// A few seconds of a recording in which something sounds, which the ear judges together: long enough for a row of
/// impulses and for a tone that starts, stops and jumps. Passages are `SoundSection`s: none holds the pause before,
/// behind or between sounds.
struct Passage {
    double from = 0.0;      // [s]
    double duration = 0.0;  // [s]
    Tones tones;            // instants count from the recording's beginning
    Onsets onsets;          // instants count from the recording's beginning
};

/// Describes one channel passage by passage as its samples come. Its memory grows with onsets and tones.
class PassageFinder {
public:
    /// Takes the `rate` [Hz] of the samples.
    explicit PassageFinder(double rate);
    ~PassageFinder();
    PassageFinder(PassageFinder&&) noexcept;
    PassageFinder& operator=(PassageFinder&&) noexcept;

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// Returns the parts of the channel: for samples that go through other filters, too, and then to `push_parted`.
    PartSquares& parts();

    /// Takes the next samples, which `parts` has taken before, in place of `push`.
    void push_parted(std::span<const double> samples);

    /// Returns the passages that are complete so far, in time.
    std::span<const Passage> found() const;

    /// Ends the recording and returns all passages, in time. One that is silent has one passage, its end; one shorter
    /// than 20 ms has none.
    std::vector<Passage> finish();

    /// Returns the loudest passage through frames of 5 ms, up to 12 kHz: an impulse is a moment there, not a stripe.
    /// Its level is within 0.5 dB of the loudest. It has no columns if all is silent.
    const signal::Spectrogram& impulses() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The longest stretch that is described as one [s].
inline constexpr double longest_stretch = 0.5;

/// Cuts one channel into stretches as its samples come, and describes each. Its memory grows by a few hundred bytes per
/// half second.
///
/// The sound is cut wherever its sustained level, the median over twelve parts of 5 ms, changes by more than 6 dB, and
/// at the latest after half a second. A median of 60 ms ignores impulses, so they stay in their stretch; the going and
/// coming phases of a rig become stretches of their own.
class StretchFinder {
public:
    /// Takes the `rate` [Hz] of the samples.
    explicit StretchFinder(double rate);
    ~StretchFinder();
    StretchFinder(StretchFinder&&) noexcept;
    StretchFinder& operator=(StretchFinder&&) noexcept;

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// Returns the parts of the channel: for samples that go through other filters, too, and then to `push_parted`.
    PartSquares& parts();

    /// Takes the next samples, which `parts` has taken before, in place of `push`.
    void push_parted(std::span<const double> samples);

    /// Returns the stretches that are complete so far, in time.
    std::span<const SoundStretch> found() const;

    /// Ends the recording and returns all stretches, in time. A rest too short to be described is left out.
    std::vector<SoundStretch> finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace stridor::sound
