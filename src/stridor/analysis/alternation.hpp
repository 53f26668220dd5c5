#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace stridor::analysis {

/// Largest lag looked at: intervals per period.
inline constexpr std::size_t largest_lag = 12;

/// How contact states alternate.
///
/// A beat is a change of state of one kind, (from, to); the times between like beats are its intervals d. At lag L a
/// sequence repeats with the mean relative mismatch m(L) = mean |d(i+L) - d(i)| / mean d. Of the kinds whose intervals
/// cover most of the judged time, and which are not rare beside the most frequent one, the best counts, for one cycle
/// may hold several unlike impacts and yet one change that comes once a cycle. Two figures follow:
///
///     regularity = 1 - m(1)            equal beats: what the ear takes for one tone
///     repetition = 1 - min over L m(L)  the pattern comes again, perhaps after several unequal beats
///
/// The coefficient of variation of the intervals is given beside them; alone it would call a perfectly periodic motion
/// with unequal beats irregular and a slowly drifting regular one, too. Intervals never reach across a cut.
struct Alternation {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    model::ContactState from = model::ContactState::slip;  // the kind of beat with the best m(1)
    model::ContactState to = model::ContactState::stick;
    long intervals = 0;           // [1] number of intervals of that kind
    double variation = unknown;   // [1] coefficient of variation of the intervals
    double regularity = unknown;  // [1] from 0 to 1; NaN with too few intervals
    double repetition = unknown;  // [1] from 0 to 1
    int lag = 1;                  // [1] beats per period
    double period = unknown;      // [s] of the pattern; mean interval where nothing repeats
    double frequency = unknown;   // [Hz] 1 / mean interval: the dominant frequency of the alternation
    std::array<double, largest_lag>
        mismatch{};  // [1] m(L) of the best kind at each lag L = index + 1; infinite if unknown
};

/// From the changes of state of a contact.
Alternation alternation(const record::ContactTally& tally);

}  // namespace stridor::analysis
