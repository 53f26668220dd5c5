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

/// The ratio that leads from one rate [Hz] to another: exact where whole numbers up to 4096 can say it, as
/// between 44.1, 48 and 51.2 kHz, else the last convergent made of such numbers, which is within 5e-7 for
/// changes of up to eightfold.
///
/// Throws `Error` (input) for a rate that is not positive, and for rates too far apart to say their ratio within 0.1 %.
RateRatio rate_ratio(double from, double to);

/// The low pass for a ratio, its frequencies as shares of the higher rate `up` times the old one: up to 0.45 of the
/// lower of both rates passes, from one half on nothing folds back.
LowPass low_pass_for(RateRatio ratio);

/// Changes the sampling rate of one channel, block by block, through a linear-phase low pass (polyphase form:
/// Crochiere, Rabiner, Multirate Digital Signal Processing, 1983).
///
/// Sample n of the output belongs to the instant n / new rate, counted from the input's first sample: nothing is
/// delayed. The input is taken as zero before its beginning and after its end. The blocks never show in the result.
class Resampler {
public:
    /// With the low pass that the ratio asks for.
    explicit Resampler(RateRatio ratio) : Resampler(ratio, low_pass_for(ratio)) {}

    /// With a low pass of one's own; its frequencies are shares of `up` times the old rate.
    Resampler(RateRatio ratio, const LowPass& design);

    /// Takes the next input samples and returns the output samples that they complete.
    std::vector<double> push(std::span<const double> input);

    /// The rest of the output after the last input sample: ceil(input * up / down) samples altogether.
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

/// A whole channel at another rate [Hz]; its unit stays.
Signal resampled(const Signal& signal, double rate);

/// A recording at another rate [Hz], still read in blocks.
std::unique_ptr<Source> resampled(std::unique_ptr<Source> source, double rate);

}  // namespace stridor::signal
