#pragma once

#include "stridor/signal/filter.hpp"
#include "stridor/signal/running_biquad.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The mean squares of a channel's equal parts, as its samples come, without what lies below a corner frequency.
///
/// The channel is taken as if its first sample had stood there for ever: that a recording begins is no noise.
class PartSquares {
public:
    /// Says whether the square of each sample is kept, too.
    enum class Samples { forgotten, kept };

    /// Takes the `rate` [Hz], the `corner` [Hz] and the length [s] of a part.
    PartSquares(double rate, double corner, double part, Samples samples = Samples::forgotten)
        : state_{{signal::high_pass(corner, rate, 2).front()}},
          length_(std::max<std::size_t>(1, static_cast<std::size_t>(part * rate))),
          samples_(samples) {}

    /// Returns the length of a part in samples.
    std::size_t length() const { return length_; }

    /// The part so far: see `signal::push_side_by_side`.
    struct State {
        signal::RunningBiquad section{};
        double sum = 0.0;           // [unit²]
        double* squared = nullptr;  // where the square of the next sample is kept, if it is

        /// Takes the next sample.
        void next(double x) {
            const double y = section.next(x);
            sum += y * y;
            if (squared != nullptr) *squared++ = y * y;
        }
    };

    /// Returns the number of samples until the part ends.
    std::size_t room() const { return length_ - filled_; }

    /// Returns the state before samples of the part.
    State begin(std::span<const double> samples) {
        if (!has_begun_) {
            state_.section.first = -state_.section.biquad.b0 * samples.front();
            state_.section.second = state_.section.biquad.b2 * samples.front();
            has_begun_ = true;
        }
        if (samples_ == Samples::kept) {
            sample_squares.resize(sample_squares.size() + samples.size());
            state_.squared = sample_squares.data() + sample_squares.size() - samples.size();
        }
        return state_;
    }

    /// Takes the state behind so many samples, and ends the part if it is whole.
    void end(const State& state, std::size_t count) {
        state_ = state;
        filled_ += count;
        if (filled_ < length_) return;
        squares.push_back(state_.sum / static_cast<double>(length_));
        state_.sum = 0.0;
        filled_ = 0;
    }

    std::vector<double> squares{};         // [unit²] of the parts that their user has not taken away
    std::vector<double> sample_squares{};  // [unit²] the same of samples

private:
    State state_;
    std::size_t length_;
    Samples samples_;
    std::size_t filled_ = 0;
    bool has_begun_ = false;
};

}  // namespace stridor::sound
