#include "stridor/analysis/alternation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stridor::analysis {

namespace {

// a kind of beat must be present over this share of the judged time to speak for the motion
constexpr double least_cover = 0.8;
// and come at least once in four of the most frequent kind: a change that is rare says nothing about a tone
constexpr double least_share = 0.25;
// lags whose mismatch lies this close to the best one repeat as well: the smallest of them is the period
constexpr double same_mismatch = 0.01;
// a best mismatch above this is no repetition, and a "period" of several intervals would be chance
constexpr double no_repetition = 0.2;
// fewest pairs of intervals a lag is judged from
constexpr std::size_t least_pairs = 3;
constexpr double infinity = std::numeric_limits<double>::infinity();

// the intervals of one kind of beat, parted where the judged time is
struct Beat {
    model::ContactState from = model::ContactState::slip;
    model::ContactState to = model::ContactState::stick;
    std::vector<std::vector<double>> stretches;  // [s]
    long intervals = 0;
    double mean = 0.0;   // [s]
    double cover = 0.0;  // [s] sum of the intervals
    std::array<double, largest_lag> mismatch{};
};

// mean |d(i+lag) - d(i)| / mean; infinite with too few pairs
double mismatch(const Beat& beat, std::size_t lag) {
    double sum = 0.0;
    std::size_t pairs = 0;
    for (const std::vector<double>& stretch : beat.stretches)
        for (std::size_t k = 0; k + lag < stretch.size(); ++k, ++pairs)
            sum += std::abs(stretch[k + lag] - stretch[k]);
    return pairs < least_pairs ? infinity : sum / static_cast<double>(pairs) / beat.mean;
}

std::vector<std::vector<double>> intervals_of(const record::Instants& instants) {
    std::vector<std::vector<double>> stretches(1);
    double last = std::numeric_limits<double>::quiet_NaN();
    for (const double time : instants.times) {
        if (std::isnan(time)) {
            if (!stretches.back().empty()) stretches.emplace_back();
        } else if (!std::isnan(last)) {
            stretches.back().push_back(time - last);
        }
        last = time;
    }
    return stretches;
}

std::optional<Beat> beat_of(const record::ContactTally& tally, model::ContactState from, model::ContactState to) {
    Beat beat{from, to, intervals_of(tally.changes[record::change_kind(from, to)])};
    for (const std::vector<double>& stretch : beat.stretches) {
        for (const double length : stretch)
            beat.cover += length;
        beat.intervals += static_cast<long>(stretch.size());
    }
    if (beat.intervals == 0) return std::nullopt;
    beat.mean = beat.cover / static_cast<double>(beat.intervals);
    for (std::size_t lag = 1; lag <= largest_lag; ++lag)
        beat.mismatch[lag - 1] = mismatch(beat, lag);
    return beat;
}

double variation(const Beat& beat) {
    double squares = 0.0;
    for (const std::vector<double>& stretch : beat.stretches)
        for (const double length : stretch)
            squares += (length - beat.mean) * (length - beat.mean);
    return std::sqrt(squares / static_cast<double>(beat.intervals)) / beat.mean;
}

// kinds of beat that speak for the motion
std::vector<Beat> speaking_beats(const record::ContactTally& tally) {
    std::vector<Beat> all;
    for (std::size_t from = 0; from < model::contact_states; ++from)
        for (std::size_t to = 0; to < model::contact_states; ++to)
            if (std::optional<Beat> beat =
                    beat_of(tally, static_cast<model::ContactState>(from), static_cast<model::ContactState>(to)))
                all.push_back(*std::move(beat));
    if (all.empty()) return all;
    // old instants are dropped, so cover is held against the longest record of any kind
    double longest = 0.0;
    long most = 0;
    for (const Beat& beat : all) {
        longest = std::max(longest, beat.cover);
        most = std::max(most, beat.intervals);
    }
    std::vector<Beat> speaking;
    for (const Beat& beat : all) {
        const bool is_rare = static_cast<double>(beat.intervals) < least_share * static_cast<double>(most);
        if (!is_rare && beat.cover >= least_cover * longest) speaking.push_back(beat);
    }
    // a frequent kind in bursts beside a rare one throughout: neither is a tone, the frequent one says so
    if (speaking.empty())
        speaking.push_back(
            *std::find_if(all.begin(), all.end(), [&](const Beat& beat) { return beat.intervals == most; }));
    return speaking;
}

// of beats alike in regularity the more frequent one is named, so that a few rounding errors do not choose
const Beat& most_regular(const std::vector<Beat>& beats) {
    const auto more_regular = [](const Beat& a, const Beat& b) {
        const double difference = a.mismatch[0] - b.mismatch[0];
        return std::abs(difference) > same_mismatch ? difference < 0.0 : a.intervals > b.intervals;
    };
    const Beat* first = &beats.front();
    for (const Beat& beat : beats)
        if (more_regular(beat, *first)) first = &beat;
    return *first;
}

// fills in the mismatch at each lag and what follows from it
void find_repetition(Alternation& result, const std::vector<Beat>& beats) {
    std::array<const Beat*, largest_lag> best_at{};
    for (std::size_t lag = 0; lag < largest_lag; ++lag)
        for (const Beat& beat : beats)
            if (beat.mismatch[lag] < result.mismatch[lag]) {
                result.mismatch[lag] = beat.mismatch[lag];
                best_at[lag] = &beat;
            }
    const double best = *std::min_element(result.mismatch.begin(), result.mismatch.end());
    if (!std::isfinite(best)) return;
    if (std::isfinite(result.mismatch[0])) result.regularity = std::max(0.0, 1.0 - result.mismatch[0]);
    result.repetition = std::max(0.0, 1.0 - best);
    if (best > no_repetition) return;
    const auto repeats = std::find_if(result.mismatch.begin(), result.mismatch.end(),
                                      [&](double m) { return m <= best + same_mismatch; });
    const auto lag = static_cast<std::size_t>(repeats - result.mismatch.begin());
    result.lag = static_cast<int>(lag) + 1;
    result.period = static_cast<double>(lag + 1) * best_at[lag]->mean;
}

}  // namespace

Alternation alternation(const record::ContactTally& tally) {
    Alternation result;
    result.mismatch.fill(infinity);
    const std::vector<Beat> beats = speaking_beats(tally);
    if (beats.empty()) return result;
    const Beat& named = most_regular(beats);
    result.from = named.from;
    result.to = named.to;
    result.intervals = named.intervals;
    result.variation = variation(named);
    result.frequency = 1.0 / named.mean;
    result.period = named.mean;
    find_repetition(result, beats);
    return result;
}

}  // namespace stridor::analysis
