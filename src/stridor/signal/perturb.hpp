#pragma once

#include "stridor/signal/source.hpp"

#include <cstdint>

namespace stridor::signal {

/// Disturbs a sound as a recording does, to test whether a verdict survives. Each function returns a changed copy.

/// Returns the signal with white Gaussian noise, `ratio` dB below its own mean square (mean taken away). The noise
/// depends on `seed` alone and has the same bits on every machine.
Signal with_noise(Signal signal, double ratio, std::uint64_t seed);

/// Returns the signal louder by `gain` dB.
Signal amplified(Signal signal, double gain);

/// Returns the signal after Butterworth filters of fourth order at `low` and `high` [Hz]; 0 leaves that end open.
Signal band_limited(const Signal& signal, double low, double high);

}  // namespace stridor::signal
