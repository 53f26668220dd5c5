#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/tally.hpp"

#include <limits>

namespace stridor::analysis {

/// How contact states alternate.
///
/// The beat of a motion is its change into stick or into separation, whichever happens more often; the times between
/// beats are its intervals d. At lag L the sequence repeats with the mean relative mismatch
///
///     m(L) = mean |d(i+L) - d(i)| / mean d,        regularity = 1 - min over L of m(L), at least 0.
///
/// The lag counts because a perfectly periodic motion may have several unequal beats per period, which the coefficient
/// of variation would call irregular. Intervals never reach across a cut (a reversal of the drive).
struct Alternation {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    model::ContactState beat = model::ContactState::stick;  // beats are changes into this state
    long intervals = 0;                                     // [1] number of intervals the figures are made from
    int lag = 1;                                            // [1] intervals per period
    double regularity = unknown;      // [1] 1 repeats exactly, 0 not at all; NaN with too few intervals
    double variation = unknown;       // [1] coefficient of variation of the intervals
    double period = unknown;          // [s] lag times the mean interval; lag 1 where nothing repeats
    double frequency = unknown;       // [Hz] 1 / period: the fundamental of the pattern
    double beat_frequency = unknown;  // [Hz] 1 / mean interval: the dominant frequency where beats are near alike
};

/// Largest lag looked at: intervals per period.
inline constexpr int largest_lag = 12;

Alternation alternation(const record::Tally& tally);

}  // namespace stridor::analysis
