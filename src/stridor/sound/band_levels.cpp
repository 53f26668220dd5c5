#include "stridor/sound/band_levels.hpp"

#include "stridor/signal/filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::sound {

namespace {

constexpr std::size_t most_bands = 4;
constexpr std::array<double, most_bands + 1> corners{1000.0, 2000.0, 4000.0, 8000.0, 14000.0};  // [Hz]
constexpr double lowest_share = 0.4;    // [1] of the rate, that a band begins below
constexpr double highest_share = 0.47;  // [1] of the rate, where it ends at the latest
constexpr double own_floor = 1e-6;      // [1] of the band's loudest part: 60 dB
constexpr double common_floor = 1e-5;   // [1] of the loudest part of all bands: 50 dB

using Lanes = std::array<double, most_bands>;

// one section of each band, side by side: each waits for itself, so four take hardly longer than one
struct Sections {
    Lanes b0{};
    Lanes b1{};
    Lanes b2{};
    Lanes a1{};
    Lanes a2{};
    Lanes first{};
    Lanes second{};

    void set(std::size_t band, const signal::Biquad& section) {
        b0[band] = section.b0;
        b1[band] = section.b1;
        b2[band] = section.b2;
        a1[band] = section.a1;
        a2[band] = section.a2;
    }

    Lanes next(const Lanes& x) {
        Lanes y;
        for (std::size_t k = 0; k < most_bands; ++k) {
            y[k] = b0[k] * x[k] + first[k];
            first[k] = b1[k] * x[k] - a1[k] * y[k] + second[k];
            second[k] = b2[k] * x[k] - a2[k] * y[k];
        }
        return y;
    }
};

}  // namespace

std::vector<double> band_levels(std::span<const double> samples, double rate, std::size_t length) {
    Sections high;
    Sections low;
    std::size_t bands = 0;
    for (; bands < most_bands && corners[bands] < lowest_share * rate; ++bands) {
        high.set(bands, signal::high_pass(corners[bands], rate, 2).front());
        low.set(bands, signal::low_pass(std::min(corners[bands + 1], highest_share * rate), rate, 2).front());
    }
    if (bands == 0) return {};

    std::vector<Lanes> squares(samples.size() / length);
    Lanes loudest{};
    for (std::size_t part = 0; part < squares.size(); ++part) {
        Lanes sums{};
        for (const double x : samples.subspan(part * length, length)) {
            const Lanes y = low.next(high.next({x, x, x, x}));
            for (std::size_t k = 0; k < most_bands; ++k)
                sums[k] += y[k] * y[k];
        }
        squares[part] = sums;
        for (std::size_t k = 0; k < most_bands; ++k)
            loudest[k] = std::max(loudest[k], sums[k]);
    }
    const double least = common_floor * *std::max_element(loudest.begin(), loudest.end());
    if (!(least > 0.0)) return std::vector<double>(squares.size());
    std::vector<double> levels;
    levels.reserve(squares.size());
    for (const Lanes& part : squares) {
        double sum = 0.0;
        for (std::size_t k = 0; k < bands; ++k)
            sum += 10.0 * std::log10(part[k] + own_floor * loudest[k] + least);
        levels.push_back(sum / static_cast<double>(bands));
    }
    return levels;
}

}  // namespace stridor::sound
