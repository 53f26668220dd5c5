#pragma once

#include "stridor/signal/resample.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stridor::signal {

/// The quantity of a motion that is listened to.
enum class MotionQuantity { velocity, acceleration };

/// One coordinate of a motion at evenly spaced instants, shape [sample] each. The displacement is continuous; velocity
/// and acceleration may jump between two instants, as at an impact.
struct MotionSamples {
    std::span<const double> displacement;  // [m]
    std::span<const double> velocity;      // [m/s]
    std::span<const double> acceleration;  // [m/s^2] between the jumps, without the pulses at them
};

/// Turns a motion with jumps into the samples of an ideal recorder of a lower rate: velocity, or acceleration with its
/// pulses at the jumps, complete up to 0.45 of the rate and zero from one half of it on.
///
/// The instants of the jumps need not be known; see the derivation in band_limit.cpp and docs/methods/auralisation.md.
/// If the samples are 16 times denser than the output, what folds back stays 90 dB (acceleration) or 110 dB (velocity)
/// below the fundamental of a repeated jump, and falls by 18 dB with each doubling. Sample n of the output belongs to
/// the instant n / rate after the first input sample.
class BandLimiter {
public:
    /// Takes the `interval` [s] between the input samples, at most a quarter of 1 / `rate`, and the `rate` [Hz] of the
    /// output.
    BandLimiter(double interval, double rate, MotionQuantity quantity);

    /// Takes the next samples of the motion and returns the output samples that they complete.
    std::vector<double> push(const MotionSamples& motion);

    /// Returns the rest of the output: one sample for each n / rate up to the last input sample.
    std::vector<double> finish();

private:
    void add_sample(double displacement, double velocity, double acceleration);
    void add_interval(double slope, double kink);
    void add_mean(double mean);
    std::vector<double> filtered();

    double interval_;  // [s]
    double share_;     // [1] of an output sample that an input sample is
    MotionQuantity quantity_;
    std::uint64_t samples_ = 0;                                        // taken
    std::uint64_t produced_ = 0;                                       // made
    double displacement_ = 0.0, velocity_ = 0.0, acceleration_ = 0.0;  // last sample
    double first_velocity_ = 0.0;                                      // [m/s]
    double slope_ = 0.0;                                               // [m/s] mean velocity of the last interval
    std::array<double, 3> kinks_{};  // [m/s] q of the interval before it, of it, and of the next
    std::array<double, 4> means_{};  // [m/s] V of four intervals, oldest first
    std::uint64_t mean_count_ = 0;
    std::vector<double> points_;  // at the input's rate, not yet filtered
    Resampler coarse_;
    Resampler fine_;
};

}  // namespace stridor::signal
