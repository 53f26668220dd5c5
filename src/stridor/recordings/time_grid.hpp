#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// A sampling rate found from a printed step.
struct SnappedRate {
    double rate = 0.0;   // [Hz]
    std::string note{};  // for the user if the rate is not simply one over the step; else empty
};

/// Returns the exact rate behind a step that a file gives with few digits.
///
/// A step of 2.08333e-05 s stands for 48000 Hz, not for 48000.768 Hz: after a million samples the two differ by 16.
/// Within `tolerance` (relative) of 1/step the usual rates of recorders are tried first, then the decimal number of the
/// fewest digits, of the rate or of the step. A note tells the rate if it is more than 1e-9 away.
SnappedRate snapped_rate(double step, double tolerance);

/// Returns the relative uncertainty of a step from its numeral: one unit of its last digit, at least 1e-9, at most
/// 5e-6, the resolution of six digits.
double step_tolerance(std::string_view numeral);

}  // namespace stridor::recordings

namespace stridor::recordings::time_grid {

// Compares the times of a table with an even grid. Private to this folder.

/// The number of times from which the rate is first taken [1].
inline constexpr std::size_t looked_at = 1024;

/// How finely the times of a table are printed.
struct Precision {
    int decimals = -400;  // most digits behind the point
    int digits = 1;       // most significant digits
};

/// Returns the precision of one numeral, with a decimal point.
Precision precision_of(std::string_view numeral);

/// Returns the finer of two precisions, in decimals and in digits: that of a table that has both.
Precision finer(Precision a, Precision b);

/// Returns the uncertainty of a time that is printed so, in its unit.
double resolution(Precision precision, double time);

/// The times of the first rows and of the last one, in the unit of the file.
struct Times {
    std::vector<double> first{};
    double last = 0.0;
    double unit = 1.0;  // [s] of one
    Precision precision{};
};

/// Returns the rate of the times: from the first rows, refined over the whole table if they tell its number of rows.
///
/// It is snapped to an exact rate within the uncertainty of the printed digits. Needs two increasing times.
SnappedRate rate_of(const Times& times);

/// Returns the time at which a row is due, counted from 0, if its own time is off by more than 5 % of a step and more
/// than the uncertainty of its digits; else `std::nullopt`. Both are in the unit of the file.
std::optional<double> missed(const Times& times, double rate, std::uint64_t row, double time);

}  // namespace stridor::recordings::time_grid
