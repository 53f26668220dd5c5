#include "stridor/sound/course.hpp"

#include "stridor/base/clones.hpp"
#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace stridor::sound {

namespace {

constexpr double envelope_time = 0.5e-3;   // [s]
constexpr double periodicity_time = 0.15;  // [s] within which the rate of impulses is taken for constant
constexpr double course_part = 0.04;       // [s]

// mean squares of half overlapped parts, each weighted by a Hann window: beats and cycles within a part leave no ripple
std::vector<double> parts_of(std::span<const double> samples, const std::vector<double>& weights) {
    const std::size_t length = weights.size();
    std::vector<double> parts;
    for (std::size_t first = 0; first + length <= samples.size(); first += length / 2) {
        double sum = 0.0;
        for (std::size_t n = 0; n < length; ++n)
            sum += weights[n] * samples[first + n] * samples[first + n];
        parts.push_back(2.0 * sum / static_cast<double>(length));
    }
    return parts;
}

using FourSums = std::array<double, 4>;  // sums side by side: each waits for itself only

// the sums of `count` values from each of four neighbouring places on
STRIDOR_CLONES FourSums four_sums(const double* values, std::size_t count) {
    FourSums sums{};
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t lane = 0; lane < sums.size(); ++lane)
            sums[lane] += values[k + lane];
    return sums;
}

// an envelope without its mean over the 60 ms around each instant
std::vector<double> without_drift(std::span<const double> values) {
    constexpr auto reach = static_cast<std::size_t>(0.03 / envelope_time);
    constexpr double width = 2 * reach + 1;
    std::vector<double> result(values.begin(), values.end());
    for (std::size_t k = 0; k < values.size();) {
        if (k >= reach && k + reach + std::tuple_size_v<FourSums> <= values.size()) {
            for (const double sum : four_sums(values.data() + k - reach, 2 * reach + 1))
                result[k++] -= sum / width;
            continue;
        }
        const std::size_t from = k - std::min(k, reach);
        const std::size_t to = std::min(values.size(), k + reach + 1);
        const auto around = values.subspan(from, to - from);
        result[k++] -= std::accumulate(around.begin(), around.end(), 0.0) / static_cast<double>(to - from);
    }
    return result;
}

// how alike an envelope is to itself after each of four neighbouring lags
STRIDOR_CLONES FourSums four_likenesses(std::span<const double> envelope, std::size_t lag) {
    FourSums products{};
    FourSums energies{};
    const std::size_t common = envelope.size() - std::min(envelope.size(), lag + products.size() - 1);
    const double* values = envelope.data();
    for (std::size_t k = 0; k < common; ++k)
        for (std::size_t lane = 0; lane < products.size(); ++lane) {
            const double later = values[k + lag + lane];
            products[lane] += values[k] * later;
            energies[lane] += values[k] * values[k] + later * later;
        }
    FourSums likenesses{};
    for (std::size_t lane = 0; lane < products.size(); ++lane) {
        for (std::size_t k = common; k + lag + lane < envelope.size(); ++k) {
            const double later = values[k + lag + lane];
            products[lane] += values[k] * later;
            energies[lane] += values[k] * values[k] + later * later;
        }
        likenesses[lane] = energies[lane] > 0.0 ? 2.0 * products[lane] / energies[lane] : 0.0;
    }
    return likenesses;
}

struct Cycle {
    double likeness = 0.0;  // [1]
    double interval = 0.0;  // [s]
};

// The greatest autocorrelation of an envelope beyond its first fall below a tenth,
// at lags that repeat at least five times.
Cycle cycle_of(std::span<const double> values) {
    const std::vector<double> envelope = without_drift(values);
    Cycle best;
    bool has_fallen = false;
    FourSums likenesses{};
    for (std::size_t lag = 1; 5 * lag <= envelope.size(); ++lag) {
        const std::size_t lane = (lag - 1) % likenesses.size();
        if (lane == 0) likenesses = four_likenesses(envelope, lag);
        const double here = likenesses[lane];
        has_fallen = has_fallen || here < 0.1;
        if (has_fallen && here > best.likeness) best = {here, envelope_time * static_cast<double>(lag)};
    }
    return best;
}

// The rate of impulses drifts: each 150 ms have their own, and the stretch the mean likeness and the likest's interval.
ImpulseTrain periodicity_of(std::span<const double> envelope) {
    const auto usual = static_cast<std::size_t>(periodicity_time / envelope_time);
    const std::size_t length = std::min(usual, envelope.size());
    ImpulseTrain train;
    if (length < 10) return train;
    const std::size_t count = envelope.size() / length;
    Cycle best;
    for (std::size_t k = 0; k < count; ++k) {
        const Cycle here = cycle_of(envelope.subspan(k * length, length));
        train.periodicity += here.likeness / static_cast<double>(count);
        if (here.likeness > best.likeness) best = here;
    }
    train.interval = best.interval;
    return train;
}

// effective values of the sound's slope over half a millisecond each
std::vector<double> envelope_of(std::span<const double> slope, double rate) {
    std::vector<double> envelope;
    const double width = envelope_time * rate;
    for (std::size_t k = 0; (static_cast<double>(k) + 1.0) * width <= static_cast<double>(slope.size()); ++k) {
        const auto from = static_cast<std::size_t>(static_cast<double>(k) * width);
        const auto to = static_cast<std::size_t>(static_cast<double>(k + 1) * width);
        double sum = 0.0;
        for (std::size_t i = from; i < to; ++i)
            sum += slope[i] * slope[i];
        envelope.push_back(std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, to - from))));
    }
    return envelope;
}

// means of three neighbours: what lasts less than a millisecond or two is one impulse
std::vector<double> smoothed(std::vector<double> values) {
    double before = values.empty() ? 0.0 : values.front();
    for (std::size_t k = 0; k + 1 < values.size(); ++k) {
        const double here = values[k];
        values[k] = (before + here + values[k + 1]) / 3.0;
        before = here;
    }
    return values;
}

// instants at which the envelope rises above a third of its peak, or twice its effective value if that is less, at
// least 2 ms after it was above last
std::vector<double> rises_of(std::span<const double> envelope) {
    std::vector<double> rises;
    if (envelope.empty()) return rises;
    const double squares = std::inner_product(envelope.begin(), envelope.end(), envelope.begin(), 0.0);
    const double limit = std::min(*std::max_element(envelope.begin(), envelope.end()) / 3.0,
                                  2.0 * std::sqrt(squares / static_cast<double>(envelope.size())));
    std::size_t quiet = 4;
    for (std::size_t k = 0; k < envelope.size(); ++k) {
        const bool is_above = envelope[k] > limit;
        if (is_above && quiet >= 4) rises.push_back(envelope_time * static_cast<double>(k));
        quiet = is_above ? 0 : quiet + 1;
    }
    return rises;
}

}  // namespace

// eight at a time: each waits for itself only
STRIDOR_CLONES SampleExtent extent_of(std::span<const double> samples) {
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> low;
    std::array<double, lanes> high;
    low.fill(SampleExtent{}.low);
    high.fill(SampleExtent{}.high);
    std::size_t first = 0;
    for (; first + lanes <= samples.size(); first += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            low[lane] = std::min(low[lane], samples[first + lane]);
            high[lane] = std::max(high[lane], samples[first + lane]);
        }
    for (; first < samples.size(); ++first) {
        low[0] = std::min(low[0], samples[first]);
        high[0] = std::max(high[0], samples[first]);
    }
    return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

Moments moments_of(std::span<const double> samples) {
    Moments moments;
    for (const double x : samples) {
        const double square = x * x;
        moments.second += square;
        moments.fourth += square * square;
        moments.peak = std::max(moments.peak, square);
    }
    const auto count = static_cast<double>(samples.size());
    return {moments.second / count, moments.fourth / count, std::sqrt(moments.peak)};
}

namespace {

// the slot of each sample, of slots that begin at `low` and are 1 / scale wide; the last one takes what lies above
STRIDOR_CLONES void slots_of(std::span<const double> samples, double low, double scale, std::span<std::int32_t> slots,
                             std::int32_t last) {
    const double* __restrict from = samples.data();
    std::int32_t* __restrict to = slots.data();
    const double most = last;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double place = (from[n] - low) * scale;
        const double inside = place > 0.0 ? place : 0.0;
        to[n] = static_cast<std::int32_t>(inside < most ? inside : most);
    }
}

}  // namespace

double largest_dwell(std::span<const double> samples, double width) {
    constexpr std::size_t slots_per_width = 8;
    constexpr std::size_t most_slots = 1U << 15U;
    const auto [low, high] = extent_of(samples);
    const double scale =
        std::min(slots_per_width / width, static_cast<double>(most_slots) / std::max(high - low, 1e-300));
    std::vector<std::uint32_t> counts(base::whole_below((high - low) * scale, most_slots) + 2);
    std::vector<std::int32_t> slots(samples.size());
    slots_of(samples, low, scale, slots, static_cast<std::int32_t>(counts.size() - 1));
    for (const std::int32_t slot : slots)
        ++counts[static_cast<std::size_t>(slot)];
    std::size_t inside = 0;
    std::size_t most = 0;
    for (std::size_t slot = 0; slot < counts.size(); ++slot) {
        inside += counts[slot];
        if (slot >= slots_per_width) inside -= counts[slot - slots_per_width];
        most = std::max(most, inside);
    }
    return static_cast<double>(most) / static_cast<double>(samples.size());
}

LevelCourse level_course(std::span<const double> samples, double rate, signal::Windows& windows) {
    const auto usual = static_cast<std::size_t>(course_part * rate);
    const std::size_t hop = std::max<std::size_t>(8, std::min(usual, samples.size() * 2 / 5)) / 2;  // half a window
    const std::vector<double> parts = parts_of(samples, windows.of(2 * hop));
    LevelCourse course;
    if (parts.size() < 4) return course;
    const double whole = *std::max_element(parts.begin(), parts.end());
    std::vector<double> levels;
    for (const double part : parts)
        levels.push_back(base::decibels_of_power(std::max(part, 1e-12 * whole)));
    const auto count = static_cast<double>(levels.size());
    const double middle = 0.5 * (count - 1.0);
    const double mean = std::accumulate(levels.begin(), levels.end(), 0.0) / count;
    double covariance = 0.0;
    double variance = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double place = static_cast<double>(k) - middle;
        covariance += place * (levels[k] - mean);
        variance += place * place;
        if (k > 0) course.abruptness = std::max(course.abruptness, std::abs(levels[k] - levels[k - 1]));
    }
    const double slope = covariance / variance;
    double rest = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double error = levels[k] - mean - slope * (static_cast<double>(k) - middle);
        rest += error * error;
    }
    course.trend = slope * rate / static_cast<double>(hop);
    course.unsteadiness = std::sqrt(rest / count);
    return course;
}

ImpulseTrain impulse_train(std::span<const double> slope, double rate) {
    const std::vector<double> envelope = smoothed(envelope_of(slope, rate));
    ImpulseTrain train = periodicity_of(envelope);
    train.instants = rises_of(envelope);
    return train;
}

}  // namespace stridor::sound
