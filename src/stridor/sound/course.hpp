#pragma once

#include "stridor/signal/window.hpp"

#include <span>
#include <vector>

/// How a sound goes in time: its level, how it rests, and its impulses. docs/methods/sound.md, section 3.
namespace stridor::sound {

/// Means of the powers of samples.
struct Moments {
    double second = 0.0;  // [unit^2] mean square
    double fourth = 0.0;  // [unit^4] mean fourth power
    double peak = 0.0;    // [unit] greatest magnitude
};

/// The moments of samples, one at least. Their mean stays in.
Moments moments_of(std::span<const double> samples);

/// Largest share of samples within a band of so much width, wherever the band lies, to an eighth of its width; 1 where
/// they never leave it.
double largest_dwell(std::span<const double> samples, double width);

/// The level of a sound over parts of 40 ms, half overlapped, against the straight line that fits it best.
struct LevelCourse {
    double abruptness = 0.0;    // [dB] greatest change from part to part
    double trend = 0.0;         // [dB/s] slope of the line
    double unsteadiness = 0.0;  // [dB] effective deviation from it
};

/// Parts are shorter where the sound has fewer than four of them; all is 0 where even those are too few.
/// `windows` are Hann's.
LevelCourse level_course(std::span<const double> samples, double rate, signal::Windows& windows);

/// The impulses of a sound.
struct ImpulseTrain {
    std::vector<double> instants;  // [s] from the first sample
    double periodicity = 0.0;      // [1] mean greatest autocorrelation of the envelope over 150 ms each
    double interval = 0.0;         // [s] between impulses where they are most periodic; 0 if they never are
};

/// Impulses are rises of the envelope of the sound's slope, in half milliseconds.
ImpulseTrain impulse_train(std::span<const double> slope, double rate);

}  // namespace stridor::sound
