#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace stridor::analysis {

/// Largest lag looked at: intervals per period. A pattern of two lips on a pane has fourteen; a thousand beats a second
/// that come again 30 times a second make 32.
inline constexpr std::size_t largest_lag = 32;

/// Beats of one kind that follow each other faster than the ear can hear, 20,000 a second, count as one. A contact that
/// comes to rest bounces ever faster, and the number of bounces depends on the engine and its step.
inline constexpr double shortest_interval = 5e-5;  // [s]

/// How unlike the intervals of a beat are at a distance of L beats.
struct Mismatch {
    double mean = std::numeric_limits<double>::infinity();  // [1] m(L); infinite if unknown
    double error = 0.0;  // [1] its standard error, from groups of its pairs in time; large with few of them
};

/// How contact states alternate.
///
/// A beat is a change of state of one kind, (from, to), or a burst of them; the times between like beats are its
/// intervals d. At lag L a sequence repeats with the mean relative mismatch m(L) = mean |d(i+L) - d(i)| / mean d, known
/// where the sequence holds L beats three times. Of the kinds whose intervals cover most of the judged time, and which
/// are not rare beside the most frequent one, the best counts, for one cycle may hold several unlike impacts and yet
/// one change that comes once a cycle. Two figures follow:
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
    long intervals = 0;                            // [1] number of intervals of that kind
    double variation = unknown;                    // [1] coefficient of variation of the intervals
    double regularity = unknown;                   // [1] from 0 to 1; NaN with too few intervals
    double repetition = unknown;                   // [1] from 0 to 1
    int lag = 1;                                   // [1] beats per period
    double period = unknown;                       // [s] of the pattern; mean interval where nothing repeats
    double frequency = unknown;                    // [Hz] 1 / mean interval: the dominant frequency of the alternation
    std::array<Mismatch, largest_lag> mismatch{};  // of the best kind at each lag L = index + 1
};

/// Returns the least mismatch of the first `lags` lags, from 1 on.
Mismatch least_mismatch(const Alternation& alternation, std::size_t lags);

/// Returns the alternation in the changes of state of a contact, by kind.
Alternation alternation(const record::Changes& changes);

}  // namespace stridor::analysis
