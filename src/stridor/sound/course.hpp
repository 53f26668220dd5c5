#pragma once

#include "stridor/signal/window.hpp"

#include <limits>
#include <span>
#include <vector>

/// The course of a sound in time: its level, its rest, and its impulses. docs/methods/sound.md, section 3.
namespace stridor::sound {

/// The smallest and the largest sample of a moment.
struct SampleExtent {
    double low = std::numeric_limits<double>::infinity();    // [unit]
    double high = -std::numeric_limits<double>::infinity();  // [unit]
};

/// Returns the extent of samples; of none, the low end lies above the high one.
SampleExtent extent_of(std::span<const double> samples);

/// Means of the powers of samples.
struct Moments {
    double second = 0.0;  // [unit^2] mean square
    double fourth = 0.0;  // [unit^4] mean fourth power
    double peak = 0.0;    // [unit] greatest magnitude
};

/// Returns the moments of at least one sample. The mean is not taken away.
Moments moments_of(std::span<const double> samples);

/// Returns the largest share of samples within a band of this width, wherever the band lies, to an eighth of its width;
/// 1 if they never leave it.
double largest_dwell(std::span<const double> samples, double width);

/// The level of a sound over parts of 40 ms, half overlapped, against the straight line that fits it best.
struct LevelCourse {
    double abruptness = 0.0;    // [dB] greatest change from part to part
    double trend = 0.0;         // [dB/s] slope of the line
    double unsteadiness = 0.0;  // [dB] effective deviation from it
};

/// Returns the course of the level. The parts are shorter if the sound has fewer than four of them; all is 0 if even
/// those are too few. `windows` must be Hann windows.
LevelCourse level_course(std::span<const double> samples, double rate, signal::Windows& windows);

/// The impulses of a sound.
struct ImpulseTrain {
    std::vector<double> instants;  // [s] from the first sample
    double periodicity = 0.0;      // [1] mean greatest autocorrelation of the envelope over 150 ms each
    double interval = 0.0;         // [s] between impulses where they are most periodic; 0 if they never are
};

/// Returns the impulses: rises of the envelope of the sound's slope, in half milliseconds.
ImpulseTrain impulse_train(std::span<const double> slope, double rate);

}  // namespace stridor::sound
