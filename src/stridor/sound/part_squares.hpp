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
        : section_{signal::high_pass(corner, rate, 2).front()},
          length_(std::max<std::size_t>(1, static_cast<std::size_t>(part * rate))),
          samples_(samples) {}

    /// Returns the length of a part in samples.
    std::size_t length() const { return length_; }

    /// Takes the next samples.
    void push(std::span<const double> samples) {
        if (!has_begun_ && !samples.empty()) begin(samples.front());
        while (!samples.empty()) {
            const std::size_t count = std::min(length_ - filled_, samples.size());
            samples_ == Samples::kept ? take<Samples::kept>(samples.first(count))
                                      : take<Samples::forgotten>(samples.first(count));
            samples = samples.subspan(count);
            filled_ += count;
            if (filled_ < length_) continue;
            squares.push_back(sum_ / static_cast<double>(length_));
            sum_ = 0.0;
            filled_ = 0;
        }
    }

    std::vector<double> squares{};         // [unit²] of the parts that their user has not taken away
    std::vector<double> sample_squares{};  // [unit²] the same of samples

private:
    void begin(double x) {
        has_begun_ = true;
        section_.first = -section_.biquad.b0 * x;
        section_.second = section_.biquad.b2 * x;
    }

    template <Samples kept>
    void take(std::span<const double> samples) {
        const std::size_t before = sample_squares.size();
        if constexpr (kept == Samples::kept) sample_squares.resize(before + samples.size());
        [[maybe_unused]] double* squared = sample_squares.data() + before;
        signal::RunningBiquad section = section_;
        double sum = sum_;
        for (const double x : samples) {
            const double y = section.next(x);
            if constexpr (kept == Samples::kept) *squared++ = y * y;
            sum += y * y;
        }
        section_ = section;
        sum_ = sum;
    }

    signal::RunningBiquad section_;
    std::size_t length_;
    Samples samples_;
    std::size_t filled_ = 0;
    bool has_begun_ = false;
    double sum_ = 0.0;
};

}  // namespace stridor::sound
