#pragma once

#include "stridor/signal/signal.hpp"

namespace stridor::signal {

/// A signal at another rate [Hz], band-limited to what both rates can hold.
///
/// Each new sample is a sum over the old ones, weighted by a sinc under a Kaiser window: 90 dB down beyond half the lower
/// rate, flat to 0.01 dB up to 0.45 of it. Samples beyond the ends are zero. Throws `Error` (input) for a rate that is not
/// positive.
Signal resampled(const Signal& signal, double rate);

}  // namespace stridor::signal
