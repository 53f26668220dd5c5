#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The most octaves that onsets are looked for in: 1 to 2, 2 to 4, 4 to 8 and 8 to 14 kHz.
inline constexpr std::size_t most_octaves = 4;

/// What the filters of onsets leave of a passage.
struct FilteredPassage {
    std::vector<double> high;                                      // [unit] above 1 kHz, shape [sample]
    std::vector<double> high_squares;                              // [unit²] of these, mean over each part
    std::vector<double> level_squares;                             // [unit²] above 100 Hz, mean over each 50 ms
    std::vector<std::array<double, most_octaves>> octave_squares;  // [unit²] sums over each part, shape [part][octave]
    std::size_t octaves = 0;                                       // that the rate has
};

/// Filters a passage at a `rate` [Hz], whose octaves are summed over parts of `length` samples. A rest that is no whole
/// part is in no sum.
FilteredPassage filter_passage(std::span<const double> samples, double rate, std::size_t length);

/// Returns the level of each part [dB], as the mean of the levels of its octaves; empty if the rate has none.
///
/// All octaves have the same weight, however weak, down to 50 dB below the greatest. So an impulse that strikes all of
/// them at once shows even if a room or a body rings on in one: the highest octaves ring the shortest.
std::vector<double> octave_levels(const FilteredPassage& passage);

}  // namespace stridor::sound
