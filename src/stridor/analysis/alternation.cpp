#include "stridor/analysis/alternation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stridor::analysis {

namespace {

using model::ContactState;

// lags whose mismatch lies this close to the best one repeat as well: the smallest of them is the period
constexpr double same_mismatch = 0.01;
// a best mismatch above this is no repetition, and a "period" of several intervals would be chance
constexpr double no_repetition = 0.2;
// fewest pairs of intervals a lag is judged from
constexpr std::size_t least_pairs = 3;

using Stretches = std::vector<std::vector<double>>;

// instants of all changes into a state, in order, parted where the tally parts them
std::vector<std::vector<double>> beats(const record::Tally& tally, ContactState into) {
    std::vector<std::vector<double>> merged;
    for (std::size_t from = 0; from < static_cast<std::size_t>(model::contact_states); ++from) {
        const record::Instants& instants = tally.changes[record::change_kind(static_cast<ContactState>(from), into)];
        std::size_t stretch = 0;
        for (const double time : instants.times) {
            if (std::isnan(time)) {
                ++stretch;
                continue;
            }
            if (merged.size() <= stretch) merged.resize(stretch + 1);
            merged[stretch].push_back(time);
        }
    }
    for (std::vector<double>& stretch : merged)
        std::sort(stretch.begin(), stretch.end());
    return merged;
}

Stretches intervals_between(const std::vector<std::vector<double>>& instants) {
    Stretches stretches;
    for (const std::vector<double>& stretch : instants) {
        std::vector<double> lengths;
        for (std::size_t k = 1; k < stretch.size(); ++k)
            lengths.push_back(stretch[k] - stretch[k - 1]);
        if (!lengths.empty()) stretches.push_back(std::move(lengths));
    }
    return stretches;
}

long count_of(const Stretches& stretches) {
    long count = 0;
    for (const std::vector<double>& stretch : stretches)
        count += static_cast<long>(stretch.size());
    return count;
}

// mean |d(i+lag) - d(i)| / mean; infinite with too few pairs
double mismatch(const Stretches& stretches, std::size_t lag, double mean) {
    double sum = 0.0;
    std::size_t pairs = 0;
    for (const std::vector<double>& stretch : stretches)
        for (std::size_t k = 0; k + lag < stretch.size(); ++k, ++pairs)
            sum += std::abs(stretch[k + lag] - stretch[k]);
    return pairs < least_pairs ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(pairs) / mean;
}

}  // namespace

Alternation alternation(const record::Tally& tally) {
    const Stretches sticks = intervals_between(beats(tally, ContactState::stick));
    const Stretches lifts = intervals_between(beats(tally, ContactState::separation));
    Alternation result;
    result.beat = count_of(lifts) > count_of(sticks) ? ContactState::separation : ContactState::stick;
    const Stretches& stretches = result.beat == ContactState::separation ? lifts : sticks;
    result.intervals = count_of(stretches);
    if (result.intervals == 0) return result;

    double sum = 0.0;
    for (const std::vector<double>& stretch : stretches)
        for (const double length : stretch)
            sum += length;
    const double mean = sum / static_cast<double>(result.intervals);
    double squares = 0.0;
    for (const std::vector<double>& stretch : stretches)
        for (const double length : stretch)
            squares += (length - mean) * (length - mean);
    result.variation = std::sqrt(squares / static_cast<double>(result.intervals)) / mean;

    std::vector<double> mismatches;
    for (std::size_t lag = 1; lag <= largest_lag; ++lag)
        mismatches.push_back(mismatch(stretches, lag, mean));
    const double best = *std::min_element(mismatches.begin(), mismatches.end());
    if (std::isfinite(best)) result.regularity = std::max(0.0, 1.0 - best);
    if (best <= no_repetition) {
        const auto first =
            std::find_if(mismatches.begin(), mismatches.end(), [&](double m) { return m <= best + same_mismatch; });
        result.lag = static_cast<int>(first - mismatches.begin()) + 1;
    }
    result.period = result.lag * mean;
    result.frequency = 1.0 / result.period;
    result.beat_frequency = 1.0 / mean;
    return result;
}

}  // namespace stridor::analysis
