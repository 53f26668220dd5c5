#pragma once

#include "stridor/signal/filter.hpp"

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
    /// Takes the `rate` [Hz], the `corner` [Hz] and the length [s] of a part.
    PartSquares(double rate, double corner, double part)
        : section_(signal::high_pass(corner, rate, 2).front()),
          length_(std::max<std::size_t>(1, static_cast<std::size_t>(part * rate))) {}

    /// Returns the length of a part in samples.
    std::size_t length() const { return length_; }

    /// Takes the next samples.
    void push(std::span<const double> samples) {
        if (!has_begun_ && !samples.empty()) begin(samples.front());
        for (const double x : samples) {
            const double y = section_.b0 * x + first_;
            first_ = section_.b1 * x - section_.a1 * y + second_;
            second_ = section_.b2 * x - section_.a2 * y;
            sum_ += y * y;
            if (++filled_ < length_) continue;
            squares.push_back(sum_ / static_cast<double>(length_));
            sum_ = 0.0;
            filled_ = 0;
        }
    }

    std::vector<double> squares{};  // [unit²] of the parts that their user has not taken away

private:
    void begin(double x) {
        has_begun_ = true;
        first_ = -section_.b0 * x;
        second_ = section_.b2 * x;
    }

    signal::Biquad section_;
    std::size_t length_;
    std::size_t filled_ = 0;
    bool has_begun_ = false;
    double sum_ = 0.0;
    double first_ = 0.0;
    double second_ = 0.0;
};

}  // namespace stridor::sound
