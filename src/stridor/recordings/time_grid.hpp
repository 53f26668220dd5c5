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
    std::string note{};  // to the user where the rate is not simply one over the step; else empty
};

/// The exact rate behind a step that a file gives with few digits.
///
/// A step of 2.08333e-05 s stands for 48000 Hz, not for 48000.768 Hz: in a million samples the two drift apart by 16.
/// Within `tolerance` (relative) of 1/step the usual rates of recorders are looked at first, then the decimal number of
/// the fewest digits, of the rate or of the step. A note says what was taken if it is more than 1e-9 away.
SnappedRate snapped_rate(double step, double tolerance);

/// By how much the step that a numeral gives may be off, relative: one unit of its last digit, at least 1e-9, at most
/// 5e-6, what six digits can tell.
double step_tolerance(std::string_view numeral);

}  // namespace stridor::recordings

namespace stridor::recordings::time_grid {

// The times of a table held against an even grid. Private to this folder.

/// Of how many times the rate is taken at first [1].
inline constexpr std::size_t looked_at = 1024;

/// How finely the times of a table are printed.
struct Precision {
    int decimals = -400;  // most digits behind the point
    int digits = 1;       // most significant digits
};

/// The precision of one numeral, with a decimal point.
Precision precision_of(std::string_view numeral);

/// The finer of two, in decimals and in digits: that of a table that has both.
Precision finer(Precision a, Precision b);

/// By how much a time printed so may be off, in the unit it is printed in.
double resolution(Precision precision, double time);

/// The times of the first rows and of the last one, in the unit of the file.
struct Times {
    std::vector<double> first{};
    double last = 0.0;
    double unit = 1.0;  // [s] of one
    Precision precision{};
};

/// The rate behind the times: from the first rows, refined over the whole table where they tell its number of rows.
///
/// Snapped to an exact one within what the printed digits leave open. Needs two increasing times.
SnappedRate rate_of(const Times& times);

/// The time a row is due at, counted from 0, where its own is off by more than 5 % of a step and what its digits leave
/// open; both in the unit of the file.
std::optional<double> missed(const Times& times, double rate, std::uint64_t row, double time);

}  // namespace stridor::recordings::time_grid
