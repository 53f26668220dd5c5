#pragma once

#include "stridor/signal/filter.hpp"
#include "stridor/signal/source.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace stridor::signal {

/// A change of the sampling rate by `up` / `down`, in lowest terms.
struct RateRatio {
    int up = 1;
    int down = 1;
};

/// Returns the ratio from one rate [Hz] to another. It is exact if whole numbers up to 4096 can express it, as between
/// 44.1, 48 and 51.2 kHz. Else it is the last convergent of such numbers, within 5e-7 for changes of up to eightfold.
///
/// Throws `Error` (input) for a rate that is not positive, and for rates so far apart that their ratio has an error
/// above 0.1 %.
RateRatio rate_ratio(double from, double to);

/// Returns the low pass for a ratio, its frequencies as shares of the higher rate `up` times the old one. It passes up
/// to 0.45 of the lower of both rates; from one half on nothing folds back.
LowPass low_pass_for(RateRatio ratio);

/// Changes the sampling rate of one channel, block by block, through a linear-phase low pass (polyphase form:
/// Crochiere, Rabiner, Multirate Digital Signal Processing, 1983).
///
/// Sample n of the output belongs to the instant n / new rate, counted from the input's first sample: nothing is
/// delayed. The input is taken as zero before its beginning and after its end. The blocks never show in the result.
class Resampler {
public:
    /// Uses the low pass that the ratio needs (`low_pass_for`).
    explicit Resampler(RateRatio ratio) : Resampler(ratio, low_pass_for(ratio)) {}

    /// Uses another low pass; its frequencies are shares of `up` times the old rate.
    Resampler(RateRatio ratio, const LowPass& design);

    /// Takes the next input samples and returns the output samples that they complete.
    std::vector<double> push(std::span<const double> input);

    /// Returns the rest of the output after the last input sample: ceil(input * up / down) samples altogether.
    std::vector<double> finish();

private:
    void produce(std::vector<double>& output, std::uint64_t known);

    RateRatio ratio_;
    std::size_t width_ = 0;        // taps per phase
    std::vector<double> taps_;     // shape [phase][width], in the order of the input
    std::size_t reach_ = 0;        // input samples needed after the one an output sample falls on or after
    std::vector<double> history_;  // input that is still needed
    std::uint64_t dropped_ = 0;    // input samples before history_, the `before_` zeros in front of the input included
    std::uint64_t before_ = 0;     // zeros in front of the input
    std::uint64_t received_ = 0;   // input samples so far
    std::uint64_t produced_ = 0;   // output samples so far
};

/// Returns a whole channel at another rate [Hz]; its unit stays.
Signal resampled(const Signal& signal, double rate);

/// Returns a recording at another rate [Hz], still read in blocks.
std::unique_ptr<Source> resampled(std::unique_ptr<Source> source, double rate);

}  // namespace stridor::signal
