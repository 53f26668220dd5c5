#pragma once

#include "stridor/sound/part_squares.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace stridor::sound {

/// A part of a recording in which something sounds, in samples from the recording's beginning.
struct SoundSection {
    std::uint64_t from = 0;
    std::uint64_t to = 0;  // the first one that is not in it
};

/// The longest section [s]; a longer sound is parted where it is quietest.
inline constexpr double longest_section = 4.0;

/// Finds where something sounds, as the samples of a channel come.
///
/// The level is the mean square of 10 ms, above 100 Hz. Something sounds where it lies within 30 dB of the greatest
/// level of the 4 s before and after. A section begins and ends exactly there. Pauses of up to 0.6 s belong to the
/// sound, for a creak rests between its impulses and a squeak between its chirps. What lasts longer than
/// `longest_section` is parted 2 to 3.5 s after its beginning, where 0.1 s are quietest. So silence or the noise of a
/// room before, behind and between sounds belongs to none of them, and no sound is cut in its midst if it has a pause.
class SectionFinder {
public:
    /// Takes the `rate` [Hz] of the samples.
    explicit SectionFinder(double rate);
    ~SectionFinder();
    SectionFinder(SectionFinder&&) noexcept;
    SectionFinder& operator=(SectionFinder&&) noexcept;

    /// Returns the parts of the channel, which take each sample before `push` does.
    PartSquares& parts();

    /// Takes so many samples more and returns the sections that have ended since, in time.
    std::vector<SoundSection> push(std::size_t samples);

    /// Ends the recording and returns the last sections. They do not depend on the blocks in which the samples came.
    std::vector<SoundSection> finish();

    /// Returns the first sample that a section still to come may hold.
    std::uint64_t needed() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace stridor::sound
