#pragma once

#include <vector>

namespace stridor::signal {

/// What a low-pass filter must do, with frequencies as shares of the sampling rate it runs at.
struct LowPass {
    double pass = 0.2;           // [1] up to here every tone keeps its level, within the stop band's residue
    double stop = 0.25;          // [1] from here on nothing is left but that residue; pass < stop <= 1/2
    double attenuation = 110.0;  // [dB] how far below the pass band that residue lies, from 50 to 180
};

/// The taps of a linear-phase low pass: an odd number, symmetric about the middle one, their sum 1.
///
/// A sinc under a Kaiser window (Kaiser, Schafer 1980; Oppenheim, Schafer, Discrete-Time Signal Processing, 7.6): the
/// cutoff lies halfway between pass and stop, about attenuation / (14.4 (stop - pass)) taps reach the attenuation.
/// Only sqrt and functions with fixed bits are called.
std::vector<double> low_pass_taps(const LowPass& design);

}  // namespace stridor::signal
