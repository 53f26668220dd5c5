#pragma once

#include <span>
#include <vector>

namespace stridor::signal {

/// One section of second order: y[n] = b0 x[n] + b1 x[n-1] + b2 x[n-2] - a1 y[n-1] - a2 y[n-2].
struct Biquad {
    double b0 = 1.0;
    double b1 = 0.0;
    double b2 = 0.0;
    double a1 = 0.0;
    double a2 = 0.0;
    bool operator==(const Biquad&) const = default;
};

/// Butterworth filters of even order as sections, by the bilinear transform with the corner put right: -3.01 dB at
/// `corner` [Hz], which lies between 0 and rate / 2. Source: Oppenheim and Schafer, Discrete-Time Signal Processing.
std::vector<Biquad> low_pass(double corner, double rate, int order = 4);

/// Likewise, for what lies above the corner.
std::vector<Biquad> high_pass(double corner, double rate, int order = 4);

/// A signal through sections, one after the other, from rest; shape [sample].
std::vector<double> filtered(std::span<const double> samples, std::span<const Biquad> sections);

/// The magnitude of the sections' frequency response at a frequency [1].
double gain_at(std::span<const Biquad> sections, double frequency, double rate);

}  // namespace stridor::signal
