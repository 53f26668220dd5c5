// A section of a filter waits for its own last result: one takes as long as several side by side, which do not wait for
// each other. So a passage goes through all of its filters at once.
#include "stridor/sound/filtered_passage.hpp"

#include "stridor/base/clones.hpp"
#include "stridor/base/decibels.hpp"
#include "stridor/signal/filter.hpp"
#include "stridor/signal/running_biquad.hpp"

#include <algorithm>

namespace stridor::sound {

namespace {

constexpr double corner = 1000.0;                                                                 // [Hz]
constexpr double level_corner = 100.0;                                                            // [Hz]
constexpr double level_time = 0.05;                                                               // [s]
constexpr std::array<double, most_octaves + 1> corners{1000.0, 2000.0, 4000.0, 8000.0, 14000.0};  // [Hz]
constexpr double lowest_share = 0.4;    // [1] of the rate, that an octave begins below
constexpr double highest_share = 0.47;  // [1] of the rate, where it ends at the latest
constexpr double own_floor = 1e-6;      // [1] of the octave's loudest part: 60 dB
constexpr double common_floor = 1e-5;   // [1] of the loudest part of all octaves: 50 dB

using Lanes = std::array<double, most_octaves>;

// one section of each octave
struct Sections {
    Lanes b0{};
    Lanes b1{};
    Lanes b2{};
    Lanes a1{};
    Lanes a2{};
    Lanes first{};
    Lanes second{};

    void set(std::size_t octave, const signal::Biquad& section) {
        b0[octave] = section.b0;
        b1[octave] = section.b1;
        b2[octave] = section.b2;
        a1[octave] = section.a1;
        a2[octave] = section.a2;
    }

    Lanes next(const Lanes& x) {
        Lanes y;
        for (std::size_t k = 0; k < most_octaves; ++k) {
            y[k] = b0[k] * x[k] + first[k];
            first[k] = b1[k] * x[k] - a1[k] * y[k] + second[k];
            second[k] = b2[k] * x[k] - a2[k] * y[k];
        }
        return y;
    }
};

signal::RunningBiquad level_section(double rate) {
    return {signal::high_pass(signal::corner_within(level_corner, rate), rate, 2).front()};
}

}  // namespace

STRIDOR_CLONES FilteredPassage filter_passage(std::span<const double> samples, double rate, std::size_t length) {
    const auto sections = signal::high_pass(signal::corner_within(corner, rate), rate, 4);
    signal::RunningBiquad one{sections.front()};
    signal::RunningBiquad other{sections.back()};
    signal::RunningBiquad level = level_section(rate);
    Sections high;
    Sections low;
    FilteredPassage passage;
    for (std::size_t k = 0; k < most_octaves && corners[k] < lowest_share * rate; ++k) {
        high.set(k, signal::high_pass(corners[k], rate, 2).front());
        low.set(k, signal::low_pass(std::min(corners[k + 1], highest_share * rate), rate, 2).front());
        ++passage.octaves;
    }
    passage.high.resize(samples.size());
    const std::size_t level_length = std::min(samples.size(), static_cast<std::size_t>(level_time * rate));
    double level_sum = 0.0;
    double high_sum = 0.0;
    Lanes sums{};
    std::size_t level_end = level_length;
    std::size_t end = length;
    for (std::size_t n = 0; n < samples.size();) {
        const std::size_t until = std::min({samples.size(), level_end, end});
        for (; n < until; ++n) {
            const double x = samples[n];
            const double y = level.next(x);
            level_sum += y * y;
            const double above = other.next(one.next(x));
            passage.high[n] = above;
            high_sum += above * above;
            const Lanes octaves = low.next(high.next({x, x, x, x}));
            for (std::size_t k = 0; k < most_octaves; ++k)
                sums[k] += octaves[k] * octaves[k];
        }
        if (n == level_end) {
            passage.level_squares.push_back(level_sum / static_cast<double>(level_length));
            level_sum = 0.0;
            level_end += level_length;
        }
        if (n == end) {
            passage.high_squares.push_back(high_sum / static_cast<double>(length));
            high_sum = 0.0;
            passage.octave_squares.push_back(sums);
            sums = {};
            end += length;
        }
    }
    return passage;
}

std::vector<double> octave_levels(const FilteredPassage& passage) {
    if (passage.octaves == 0) return {};
    const auto& squares = passage.octave_squares;
    Lanes loudest{};
    for (const Lanes& part : squares)
        for (std::size_t k = 0; k < most_octaves; ++k)
            loudest[k] = std::max(loudest[k], part[k]);
    const double least = common_floor * *std::max_element(loudest.begin(), loudest.end());
    std::vector<double> levels(squares.size());
    if (!(least > 0.0)) return levels;
    std::vector<double> octave(squares.size());
    for (std::size_t k = 0; k < passage.octaves; ++k) {
        for (std::size_t part = 0; part < squares.size(); ++part)
            octave[part] = squares[part][k] + own_floor * loudest[k] + least;
        base::make_decibels(octave);
        for (std::size_t part = 0; part < squares.size(); ++part)
            levels[part] += octave[part];
    }
    for (double& level : levels)
        level /= static_cast<double>(passage.octaves);
    return levels;
}

}  // namespace stridor::sound
