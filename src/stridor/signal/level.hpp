#pragma once

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

    /// Returns the level so far.
    LevelHistory history() const;

private:
    void keep();

    double rate_;
    double reference_;
    double share_;  // of the average that one sample replaces
    std::size_t stride_;
    std::size_t until_ = 0;  // samples until the next value is kept
    double mean_square_ = 0.0;
    double peak_ = 0.0;           // greatest mean square since the last value kept
    double greatest_ = 0.0;       // of all
    std::vector<double> kept_{};  // greatest mean squares
};

}  // namespace stridor::signal
