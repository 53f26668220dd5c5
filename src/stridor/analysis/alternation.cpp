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
// the pairs of a lag are held against each other in so many groups, one after the other in time
constexpr std::size_t pair_groups = 8;

// the intervals of one kind of beat, parted where the judged time is
struct Beat {
    model::ContactState from = model::ContactState::slip;
    model::ContactState to = model::ContactState::stick;
    std::vector<std::vector<double>> stretches;  // [s]
    long intervals = 0;
    double mean = 0.0;   // [s]
    double cover = 0.0;  // [s] sum of the intervals
    std::array<Mismatch, largest_lag> mismatch{};
};

std::size_t pairs_of(const Beat& beat, std::size_t lag) {
    std::size_t pairs = 0;
    for (const std::vector<double>& stretch : beat.stretches)
        pairs += stretch.size() > lag ? stretch.size() - lag : 0;
    return pairs;
}

// some of the pairs of a lag
struct PairGroup {
    double sum = 0.0;    // [s] of |d(i+lag) - d(i)|
    double count = 0.0;  // [1]
};

// standard error of the mean of all pairs, from how far those of groups alike in size lie from it
double scatter_in_time(const std::vector<PairGroup>& groups, double mean) {
    double squares = 0.0;
    for (const PairGroup& group : groups) {
        const double deviation = group.sum / group.count - mean;
        squares += deviation * deviation;
    }
    return std::sqrt(squares / static_cast<double>(groups.size() * (groups.size() - 1)));
}

// the same, from stretches of any size; 0 of one alone
double scatter_of_stretches(const std::vector<PairGroup>& stretches, double mean) {
    double squares = 0.0, pairs = 0.0, filled = 0.0;
    for (const PairGroup& stretch : stretches) {
        const double deviation = stretch.sum - stretch.count * mean;
        squares += deviation * deviation;
        pairs += stretch.count;
        filled += stretch.count > 0.0 ? 1.0 : 0.0;
    }
    return filled > 1.0 ? std::sqrt(squares * filled / (filled - 1.0)) / pairs : 0.0;
}

// mean |d(i+lag) - d(i)| / mean, and how far it scatters: between pieces of time, or between strokes that may be
// unlike, each alike in itself; the pattern must be seen three times
Mismatch mismatch(const Beat& beat, std::size_t lag) {
    const std::size_t pairs = pairs_of(beat, lag);
    if (pairs < std::max(2 * lag, least_pairs)) return {};
    const std::size_t groups = std::min(pair_groups, pairs);
    std::vector<PairGroup> in_time(groups), stretches(beat.stretches.size());
    double sum = 0.0;
    std::size_t pair = 0;
    for (std::size_t stretch = 0; stretch < stretches.size(); ++stretch) {
        const std::vector<double>& lengths = beat.stretches[stretch];
        for (std::size_t k = 0; k + lag < lengths.size(); ++k, ++pair) {
            const double difference = std::abs(lengths[k + lag] - lengths[k]);
            sum += difference;
            for (PairGroup* group : {&in_time[pair * groups / pairs], &stretches[stretch]}) {
                group->sum += difference;
                group->count += 1.0;
            }
        }
    }
    const double mean = sum / static_cast<double>(pairs);
    const double scatter = std::max(scatter_in_time(in_time, mean), scatter_of_stretches(stretches, mean));
    return {mean / beat.mean, scatter / beat.mean};
}

// of a burst the first counts
std::vector<std::vector<double>> intervals_of(const record::Instants& instants) {
    std::vector<std::vector<double>> stretches(1);
    double last = std::numeric_limits<double>::quiet_NaN();
    double first_of_burst = last;
    for (const double time : instants.times) {
        if (std::isnan(time) && !stretches.back().empty()) stretches.emplace_back();
        const bool is_burst = time - last < shortest_interval;
        last = time;
        if (is_burst) continue;
        if (!std::isnan(time - first_of_burst)) stretches.back().push_back(time - first_of_burst);
        first_of_burst = time;
    }
    return stretches;
}

std::optional<Beat> beat_of(const record::Changes& changes, model::ContactState from, model::ContactState to) {
    Beat beat{from, to, intervals_of(changes[record::change_kind(from, to)])};
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
std::vector<Beat> speaking_beats(const record::Changes& changes) {
    std::vector<Beat> all;
    for (std::size_t from = 0; from < model::contact_states; ++from)
        for (std::size_t to = 0; to < model::contact_states; ++to)
            if (std::optional<Beat> beat =
                    beat_of(changes, static_cast<model::ContactState>(from), static_cast<model::ContactState>(to)))
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
        const double difference = a.mismatch[0].mean - b.mismatch[0].mean;
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
            if (beat.mismatch[lag].mean < result.mismatch[lag].mean) {
                result.mismatch[lag] = beat.mismatch[lag];
                best_at[lag] = &beat;
            }
    const Mismatch best = least_mismatch(result, largest_lag);
    if (!std::isfinite(best.mean)) return;
    if (std::isfinite(result.mismatch[0].mean)) result.regularity = std::max(0.0, 1.0 - result.mismatch[0].mean);
    result.repetition = std::max(0.0, 1.0 - best.mean);
    if (best.mean > no_repetition) return;
    const auto repeats = std::find_if(result.mismatch.begin(), result.mismatch.end(),
                                      [&](const Mismatch& m) { return m.mean <= best.mean + same_mismatch; });
    const auto lag = static_cast<std::size_t>(repeats - result.mismatch.begin());
    result.lag = static_cast<int>(lag) + 1;
    result.period = static_cast<double>(lag + 1) * best_at[lag]->mean;
}

}  // namespace

Mismatch least_mismatch(const Alternation& alternation, std::size_t lags) {
    return *std::min_element(alternation.mismatch.begin(),
                             alternation.mismatch.begin() + static_cast<std::ptrdiff_t>(std::min(lags, largest_lag)),
                             [](const Mismatch& a, const Mismatch& b) { return a.mean < b.mean; });
}

Alternation alternation(const record::Changes& changes) {
    Alternation result;
    const std::vector<Beat> beats = speaking_beats(changes);
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
