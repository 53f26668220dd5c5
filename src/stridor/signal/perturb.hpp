#pragma once

#include "stridor/signal/source.hpp"

#include <cstdint>

namespace stridor::signal {

/// What a recording does to a sound, to see whether a verdict outlives it. Each returns a changed copy.

/// The signal with white Gaussian noise, `ratio` dB below its own mean square (mean taken away). The noise follows from
/// `seed` alone, the same bits on every machine.
Signal with_noise(Signal signal, double ratio, std::uint64_t seed);

/// The signal louder by `gain` dB.
Signal amplified(Signal signal, double gain);

/// The signal through Butterworth filters of fourth order at `low` and `high` [Hz]; 0 leaves that end open.
Signal band_limited(const Signal& signal, double low, double high);

}  // namespace stridor::signal
