#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// Returns the quantity of 0 dB: 20 uPa (ISO 1683), 1e-9 m/s, 1e-6 m/s^2, 1e-6 N; for "FS" and every other unit 1 of
/// the unit itself.
double reference_of(std::string_view unit);

/// Returns the label of a level of samples in this unit: "dB re 20 uPa", "dB re FS".
std::string level_unit(std::string_view unit);

/// Returns 10 lg(mean square / reference²) [dB]; minus infinity for silence.
double level_of(double mean_square, double reference);

/// A level over time: exponentially averaged with a time constant, kept at equal intervals.
struct LevelHistory {
    double interval = 0.0;                                       // [s] between values; the first stands at `interval`
    std::vector<double> decibels;                                // [dB] shape [instant]
    double greatest = -std::numeric_limits<double>::infinity();  // [dB] of all samples, not only those kept
};

/// The time constant of sound level meters' "fast" (IEC 61672-1) [s].
inline constexpr double fast = 0.125;

/// Averages the square of samples exponentially, d(m)/dt = (x² - m) / time constant, from m = 0.
class LevelMeter {
public:
    /// Makes a meter that keeps a value every 50 ms. In a long recording the interval grows, so that there are never
    /// more than 8192 values.
    LevelMeter(double rate, double reference, double time_constant = fast);

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// The averages so far: see `push_side_by_side`.
    struct State {
        double share = 0.0;        // of the average that one sample replaces
        double squares = 0.0;      // sum of all
        double mean_square = 0.0;  // exponential
        double peak = 0.0;         // greatest mean square since the last value kept

        /// Takes the next sample.
        void next(double x) {
            const double square = x * x;
            squares += square;
            mean_square += share * (square - mean_square);
            peak = std::max(peak, mean_square);
        }
    };

    /// Returns the number of samples until the next value is kept.
    std::size_t room() const { return until_; }

    /// Returns the state before samples.
    State begin(std::span<const double> /*samples*/) const { return state_; }

    /// Takes the state behind so many samples, and keeps a value if it is time.
    void end(const State& state, std::size_t count);

    /// Returns the sum of the squares of all samples so far.
    double squares() const { return state_.squares; }

    /// Returns the level so far.
    LevelHistory history() const;

private:
    void keep();

    double rate_;
    double reference_;
    State state_;
    std::size_t stride_;
    std::size_t until_ = 0;       // samples until the next value is kept
    double greatest_ = 0.0;       // of all
    std::vector<double> kept_{};  // greatest mean squares
};

}  // namespace stridor::signal
