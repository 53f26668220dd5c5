#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
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

/// Returns a Butterworth low pass of even order as sections, by the bilinear transform with prewarping: -3.01 dB at
/// `corner` [Hz], which lies between 0 and rate / 2. Source: Oppenheim and Schafer, Discrete-Time Signal Processing.
std::vector<Biquad> low_pass(double corner, double rate, int order = 4);

/// Returns a Butterworth high pass of even order as sections, with -3.01 dB at `corner` [Hz].
std::vector<Biquad> high_pass(double corner, double rate, int order = 4);

/// Returns a corner [Hz] that a rate [Hz] can have: the one that is wanted, a quarter of the rate at most.
inline double corner_within(double wanted, double rate) {
    return std::min(wanted, 0.25 * rate);
}

/// Returns a signal after the sections, one after the other, from rest; shape [sample].
std::vector<double> filtered(std::span<const double> samples, std::span<const Biquad> sections);

/// Returns the magnitude of the sections' frequency response at a frequency [1].
double gain_at(std::span<const Biquad> sections, double frequency, double rate);

/// Requirements of a low-pass filter, with frequencies as shares of the sampling rate at which it runs.
struct LowPass {
    double pass = 0.2;           // [1] up to here every tone keeps its level, within the stop band's residue
    double stop = 0.25;          // [1] from here on only that residue is left; pass < stop <= 1/2
    double attenuation = 110.0;  // [dB] how far below the pass band that residue lies, from 50 to 180
};

/// Returns the taps of a linear-phase low pass: an odd number, symmetric about the middle one, with sum 1.
///
/// A sinc under a Kaiser window (Kaiser, Schafer 1980; Oppenheim, Schafer, Discrete-Time Signal Processing, 7.6): the
/// cutoff lies halfway between pass and stop, about attenuation / (14.4 (stop - pass)) taps reach the attenuation.
/// Only sqrt and functions with fixed bits are called.
std::vector<double> low_pass_taps(const LowPass& design);

/// Third-octave bands of ISO 532-1: 25 Hz to 12.5 kHz.
inline constexpr std::size_t third_octave_count = 28;
inline constexpr std::array<double, third_octave_count> third_octave_names{
    25.0,  31.5,  40.0,   50.0,   63.0,   80.0,   100.0,  125.0,  160.0,  200.0,  250.0,  315.0,  400.0,   500.0,
    630.0, 800.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0, 3150.0, 4000.0, 5000.0, 6300.0, 8000.0, 10000.0, 12500.0};

/// One number for each third-octave band.
using ThirdOctaves = std::array<double, third_octave_count>;

/// The rate for which the filters are made [Hz].
inline constexpr double third_octave_rate = 48000.0;

/// The filters of ISO 532-1:2017 (tables A.1 and A.2), 28 third-octave bands of three second-order sections each at
/// 48 kHz, class 1 of IEC 61260-1, with the smoothed power of each band.
///
/// The power of a band is its output squared and smoothed by three equal first-order low passes; their time constant is
/// 2/(3 f) at a band's centre f up to 1 kHz and 2/3 ms above (ISO 532-1, 6.3).
class ThirdOctaveFilters {
public:
    /// Begins at rest.
    ThirdOctaveFilters();

    /// Takes samples at 48 kHz. Calls `take` with the smoothed powers [unit²] at the first of them and at each 24th
    /// after it: 2000 times a second.
    void push(std::span<const double> samples, const std::function<void(const ThirdOctaves&)>& take);

    /// Returns the mean squares of the bands over all samples [unit²]; zeros before the first.
    ThirdOctaves mean_squares() const;

private:
    struct Section {
        ThirdOctaves a1{};  // denominator 1 + a1/z + a2/z²
        ThirdOctaves a2{};
        ThirdOctaves first{};  // state, transposed direct form II
        ThirdOctaves second{};
    };

    void filter(double sample);
    void smooth();
    void forget();

    std::array<Section, 3> sections_{};
    ThirdOctaves output_{};
    ThirdOctaves share_{};                    // [1] of a smoothed value that one sample replaces
    std::array<ThirdOctaves, 3> smoothed_{};  // [unit²]
    ThirdOctaves squares_{};                  // [unit²] sum
    std::size_t count_ = 0;                   // samples so far
};

}  // namespace stridor::signal
