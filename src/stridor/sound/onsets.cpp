#include "stridor/sound/onsets.hpp"

#include "stridor/base/decibels.hpp"
#include "stridor/signal/median.hpp"
#include "stridor/sound/filtered_passage.hpp"
#include "stridor/sound/rhythm.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

// The envelope is the mean square of parts of 2 ms of what lies above 1 kHz. An onset is where the energy of the
// 8 ms after an instant exceeds that of the 8 ms before by 4.5 dB, most of its surroundings. The same is asked of the
// mean level of octaves, which shows what strikes all of them at once.
namespace stridor::sound {

namespace {

constexpr double part_time = 0.002;         // [s]
constexpr std::size_t step_parts = 4;       // 8 ms
constexpr std::size_t short_parts = 2;      // 4 ms, for impulses of which the next one comes before 16 ms have passed
constexpr std::size_t apart = 3;            // parts on either side that an onset exceeds
constexpr double least_step = 4.5;          // [dB]
constexpr std::size_t lasting = 50;         // parts of a lasting level, 0.1 s
constexpr std::size_t steady = 100;         // parts of a steady level, 0.2 s
constexpr double depth = 20.0;              // [dB] below the greatest level there is nothing to hear
constexpr double level_floor = 1e-6;        // [1] of the loudest part of 50 ms: quieter ones are all the same
constexpr double step_floor = 3e-4;         // [1] the same of 2 ms: 35 dB below it pauses are alike, silent or not
constexpr double joint_depth = 40.0;        // [dB] the same of the mean level of octaves
constexpr double fast_part_time = 0.0005;   // [s]
constexpr std::size_t fast_step_parts = 4;  // 2 ms
constexpr std::size_t fast_lasting = 200;   // 0.1 s
constexpr double longest_fast_interval = 0.06;  // [s]
constexpr std::size_t least_row = 4;            // onsets: by chance few follow each other at like intervals
constexpr std::size_t least_fast_row = 8;       // steps of 2 ms are more often those of noise
constexpr double most_interval_change = 1.741;  // [1] of an interval to the next, 0.8 octaves
constexpr double longest_interval = 0.35;       // [s] within a train

std::vector<double> squares_of(std::span<const double> samples, std::size_t length) {
    std::vector<double> squares(samples.size() / length);
    for (std::size_t k = 0; k < squares.size(); ++k) {
        for (const double x : samples.subspan(k * length, length))
            squares[k] += x * x;
        squares[k] /= static_cast<double>(length);
    }
    return squares;
}

// the mean of `width` values around each, fewer at the ends
std::vector<double> means_of(std::span<const double> values, std::size_t width) {
    std::vector<double> sums(values.size() + 1);
    std::partial_sum(values.begin(), values.end(), sums.begin() + 1);
    std::vector<double> means(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::size_t from = k - std::min(k, width / 2);
        const std::size_t to = std::min(values.size(), k - std::min(k, width / 2) + width);
        means[k] = (sums[to] - sums[from]) / static_cast<double>(to - from);
    }
    return means;
}

std::vector<double> levels_of(std::span<const double> squares, double least) {
    std::vector<double> levels(squares.size());
    for (std::size_t k = 0; k < squares.size(); ++k)
        levels[k] = squares[k] + least;
    base::make_decibels(levels);
    return levels;
}

// which values lie within `depth` of the greatest
std::vector<std::uint8_t> loud_parts(std::span<const double> levels) {
    const double greatest = *std::max_element(levels.begin(), levels.end());
    std::vector<std::uint8_t> loud(levels.size());
    for (std::size_t k = 0; k < levels.size(); ++k)
        loud[k] = levels[k] > greatest - depth ? 1 : 0;
    return loud;
}

// [dB] shape [part]: the level of `width` parts from each part on over that of as many before it
std::vector<double> steps_of(std::span<const double> squares, double least, std::size_t width) {
    std::vector<double> sums(squares.size() + 1);
    for (std::size_t k = 0; k < squares.size(); ++k)
        sums[k + 1] = sums[k] + squares[k] + least;
    std::vector<double> steps(squares.size(), 1.0);
    for (std::size_t k = 1; k < squares.size(); ++k) {
        const std::size_t to = std::min(squares.size(), k + width);
        const std::size_t from = k - std::min(k, width);
        const double after = (sums[to] - sums[k]) / static_cast<double>(to - k);
        const double before = (sums[k] - sums[from]) / static_cast<double>(k - from);
        steps[k] = after / before;
    }
    base::make_decibels(steps);
    return steps;
}

// [dB] shape [part]: the same of levels
std::vector<double> steps_of_levels(std::span<const double> levels, std::size_t width) {
    std::vector<double> sums(levels.size() + 1);
    std::partial_sum(levels.begin(), levels.end(), sums.begin() + 1);
    std::vector<double> steps(levels.size());
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const std::size_t to = std::min(levels.size(), k + width);
        const std::size_t from = k - std::min(k, width);
        steps[k] =
            (sums[to] - sums[k]) / static_cast<double>(to - k) - (sums[k] - sums[from]) / static_cast<double>(k - from);
    }
    return steps;
}

// steps that are the greatest of the parts before, `apart`, and of those that their energy is taken from, `width`
std::vector<std::size_t> onset_parts(std::span<const double> steps, std::span<const std::uint8_t> loud,
                                     std::size_t width = step_parts, std::size_t before = apart) {
    std::vector<std::size_t> onsets;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!(steps[k] >= least_step)) continue;
        const std::size_t from = k - std::min(k, before);
        const std::size_t to = std::min(steps.size(), k + width);
        const auto around = steps.subspan(from, to - from);
        const auto heard = loud.subspan(from, to - from);
        const bool is_heard = std::find(heard.begin(), heard.end(), 1) != heard.end();
        if (is_heard && steps[k] >= *std::max_element(around.begin(), around.end())) onsets.push_back(k);
    }
    return onsets;
}

struct StepMoments {
    double deviation = 0.0;
    double skewness = 0.0;  // [1] steps of a fraction of a decibel do not count as skewed
};

StepMoments moments_of(std::span<const double> values, std::span<const std::uint8_t> counted) {
    double count = 0.0;
    double mean = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        count += counted[k];
        mean += counted[k] * values[k];
    }
    if (!(count > 0.0)) return {};
    mean /= count;
    double second = 0.0;
    double third = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double away = counted[k] * (values[k] - mean);
        second += away * away;
        third += away * away * away;
    }
    const double deviation = std::sqrt(second / count);
    const double scale = deviation + 0.3;
    return {deviation, third / count / (scale * scale * scale)};
}

struct Rows {
    double taken = 0.0;    // [s]
    double longest = 0.0;  // [1] onsets
};

// what counts as a row of onsets
struct RowRule {
    double longest = longest_interval;  // [s] between two onsets
    std::size_t least = least_row;      // onsets
};

// rows of onsets whose intervals change by less than `most_interval_change` from one to the next
Rows rows_of(std::span<const double> instants, const RowRule& rule) {
    Rows rows;
    const auto interval = [&](std::size_t k) { return instants[k + 1] - instants[k]; };
    const auto goes_on = [&](std::size_t k) {  // from interval k to the next
        const double ratio = interval(k + 1) / interval(k);
        return std::max(interval(k), interval(k + 1)) < rule.longest && ratio < most_interval_change &&
               ratio * most_interval_change > 1.0;
    };
    for (std::size_t k = 0; k + 2 < instants.size();) {
        std::size_t end = k;
        while (end + 2 < instants.size() && goes_on(end))
            ++end;
        if (end - k + 2 >= rule.least) {
            rows.taken += instants[end + 1] - instants[k];
            rows.longest = std::max(rows.longest, static_cast<double>(end - k + 2));
        }
        k = std::max(end, k + 1);
    }
    return rows;
}

// levels less their median over 0.2 s, which is found every 20 ms; a pause counts in neither
double beat_of(std::span<const double> levels, std::span<const std::uint8_t> loud) {
    constexpr std::size_t every = 10;
    std::vector<double> knots;
    for (std::size_t k = 0; k < levels.size() + every; k += every) {
        const std::size_t place = std::min(k, levels.size() - 1);
        const std::size_t from = place - std::min(place, steady / 2);
        const std::size_t to = std::min(levels.size(), place + steady / 2);
        std::vector<double> heard;
        for (std::size_t j = from; j < to; ++j)
            if (loud[j] != 0) heard.push_back(levels[j]);
        knots.push_back(heard.empty() ? levels[place] : signal::median_of(heard));
    }
    std::vector<double> away(levels.size());
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double share = static_cast<double>(k % every) / static_cast<double>(every);
        away[k] = levels[k] - (1.0 - share) * knots[k / every] - share * knots[k / every + 1];
    }
    return moments_of(away, loud).deviation;
}

void describe_levels(std::span<const double> squares, Onsets& onsets) {
    const double greatest = *std::max_element(squares.begin(), squares.end());
    if (!(greatest > 0.0)) return;
    const std::vector<double> levels = levels_of(squares, level_floor * greatest);
    const std::vector<std::uint8_t> loud = loud_parts(levels);
    onsets.level_spread = moments_of(levels, loud).deviation;
    const auto first = std::find(loud.begin(), loud.end(), 1);
    if (first == loud.end()) return;
    // silence before and after is no pause
    const auto last = std::find(loud.rbegin(), loud.rend(), 1).base();
    onsets.sounding = std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

// of the parts of `length` samples that count
double kurtosis_of(std::span<const double> samples, std::size_t length, std::span<const std::uint8_t> counted) {
    double second = 0.0;
    double fourth = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < counted.size(); ++k) {
        if (counted[k] == 0) continue;
        count += static_cast<double>(length);
        for (const double x : samples.subspan(k * length, length)) {
            second += x * x;
            fourth += x * x * x * x;
        }
    }
    const double square = second * second;  // of what is all but silent it is zero
    return square > 0.0 ? fourth * count / square : 0.0;
}

std::vector<double> instants_of(std::span<const std::size_t> parts, double part) {
    std::vector<double> instants;
    for (const std::size_t k : parts)
        instants.push_back(part * static_cast<double>(k));
    return instants;
}

// the same of parts of half a millisecond: impulses that follow each other within 5 to 60 ms
void describe_fast(std::span<const double> sound, double rate, Onsets& onsets) {
    const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(fast_part_time * rate)));
    const std::vector<double> squares = squares_of(sound, length);
    const double least = step_floor * *std::max_element(squares.begin(), squares.end());
    if (!(least > 0.0)) return;
    const double part = static_cast<double>(length) / rate;  // [s]
    const std::vector<std::uint8_t> loud = loud_parts(levels_of(means_of(squares, fast_lasting), least));
    const std::vector<double> steps = steps_of(squares, least, fast_step_parts);
    const std::vector<double> instants = instants_of(onset_parts(steps, loud, fast_step_parts, fast_step_parts), part);
    const double lasted = part * std::accumulate(loud.begin(), loud.end(), 0.0);
    const Rows rows = rows_of(instants, {longest_fast_interval, least_fast_row});
    onsets.fast_rate = static_cast<double>(instants.size()) / lasted;
    onsets.fast_skewness = moments_of(steps, loud).skewness;
    onsets.fast_train = std::min(1.0, rows.taken / lasted);
    onsets.longest_fast_train = rows.longest;
}

}  // namespace

Onsets onsets_of(std::span<const double> samples, double rate) {
    Onsets onsets;
    const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(part_time * rate)));
    const FilteredPassage filtered = filter_passage(samples, rate, length);
    const std::vector<double>& sound = filtered.high;
    describe_levels(filtered.level_squares, onsets);
    const std::vector<double>& squares = filtered.high_squares;
    const double greatest = *std::max_element(squares.begin(), squares.end());
    if (!(greatest > 0.0)) return onsets;
    const double least = step_floor * greatest;
    const double part = static_cast<double>(length) / rate;  // [s]

    const std::vector<std::uint8_t> loud = loud_parts(levels_of(means_of(squares, lasting), least));
    onsets.kurtosis = kurtosis_of(sound, length, loud);
    const std::vector<double> steps = steps_of(squares, least, step_parts);
    const double lasted = part * std::accumulate(loud.begin(), loud.end(), 0.0);
    onsets.instants = instants_of(onset_parts(steps, loud), part);
    onsets.rate = static_cast<double>(onsets.instants.size()) / lasted;
    onsets.skewness =
        std::max(moments_of(steps, loud).skewness, moments_of(steps_of(squares, least, short_parts), loud).skewness);
    const Rows rows = rows_of(onsets.instants, {});
    onsets.train = std::min(1.0, rows.taken / lasted);
    onsets.longest_train = rows.longest;
    onsets.beat = beat_of(levels_of(means_of(squares, step_parts), least), loud);
    onsets.rhythm = rhythm_of(squares, part);

    describe_fast(sound, rate, onsets);

    std::vector<double> levels = octave_levels(filtered);
    if (levels.empty()) return onsets;
    const double lowest = *std::max_element(levels.begin(), levels.end()) - joint_depth;
    for (double& level : levels)
        level = std::max(level, lowest);
    const std::vector<double> joint = steps_of_levels(levels, step_parts);
    onsets.joint_skewness =
        std::max(moments_of(joint, loud).skewness, moments_of(steps_of_levels(levels, short_parts), loud).skewness);
    onsets.joint_train = rows_of(instants_of(onset_parts(joint, loud), part), {}).longest;
    return onsets;
}

}  // namespace stridor::sound
