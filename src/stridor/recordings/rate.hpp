#pragma once

#include <string>
#include <string_view>

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
