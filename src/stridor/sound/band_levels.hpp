#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The level of a sound over its parts of `length` samples, as the mean of the levels [dB] of octaves from 1 kHz up:
/// 1 to 2, 2 to 4, 4 to 8 and 8 to 14 kHz, as far as the rate [Hz] has them; empty if it has none.
///
/// All octaves weigh the same, however weak, down to 50 dB below the greatest. So what strikes all of them at once
/// shows even where a room or a body rings on in one: the highest octaves ring the shortest.
std::vector<double> band_levels(std::span<const double> samples, double rate, std::size_t length);

}  // namespace stridor::sound
