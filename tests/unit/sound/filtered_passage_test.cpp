#include "stridor/sound/filtered_passage.hpp"

#include "stridor/signal/filter.hpp"
#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {
namespace {

using support::sampled;
using support::sine;

constexpr std::size_t part = 96;  // 2 ms

std::vector<double> levels_of(const signal::Signal& sound) {
    return octave_levels(filter_passage(sound.samples, sound.rate, part));
}

double greatest_rise(const std::vector<double>& levels) {
    double rise = 0.0;
    for (std::size_t k = levels.size() / 10; k + 4 < levels.size(); ++k)
        rise = std::max(rise, levels[k + 4] - levels[k]);
    return rise;
}

TEST(OctaveLevels, RiseAndFallWithTheGainInAllOctaves) {
    const signal::Signal hiss = support::hiss(1.0);
    signal::Signal louder = hiss;
    for (double& sample : louder.samples)
        sample *= 10.0;
    const std::vector<double> a = levels_of(hiss);
    const std::vector<double> b = levels_of(louder);
    ASSERT_EQ(a.size(), hiss.samples.size() / part);
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_NEAR(b[k] - a[k], 20.0, 1e-9);
}

// a tone at 1.5 kHz rings on as in a room; what strikes above is 20 dB weaker: it adds 0.13 dB to the whole level
TEST(OctaveLevels, ShowWhatStrikesUnderALouderTone) {
    const auto ringing = [](double t) { return sine(1500.0 * t); };
    const auto struck = [&](double t) {
        const double strike = std::exp(-std::fmod(t, 0.1) / 0.005);
        return ringing(t) + 0.1 * strike * (sine(3000.0 * t) + sine(6000.0 * t) + sine(11000.0 * t));
    };
    EXPECT_LT(greatest_rise(levels_of(sampled(1.0, ringing))), 0.5);
    EXPECT_GT(greatest_rise(levels_of(sampled(1.0, struck))), 2.0);
}

TEST(OctaveLevels, HaveTheOctavesThatTheRateHas) {
    const std::vector<double> samples(1000, 0.1);
    EXPECT_TRUE(octave_levels(filter_passage(samples, 2000.0, 4)).empty());
    EXPECT_EQ(octave_levels(filter_passage(samples, 8000.0, 16)).size(), 62u);
}

TEST(OctaveLevels, OfSilenceAreAllTheSame) {
    const std::vector<double> levels = octave_levels(filter_passage(std::vector<double>(4800), 48000.0, part));
    EXPECT_EQ(levels, std::vector<double>(50));
}

// sums of the squares of parts
std::vector<double> sums_of(std::span<const double> samples, std::size_t length) {
    std::vector<double> sums(samples.size() / length);
    for (std::size_t n = 0; n < sums.size() * length; ++n)
        sums[n / length] += samples[n] * samples[n];
    return sums;
}

TEST(FilteredPassage, IsWhatEachFilterLeavesAlone) {
    const signal::Signal hiss = support::hiss(0.333);  // no whole part at its end
    const FilteredPassage passage = filter_passage(hiss.samples, hiss.rate, part);
    EXPECT_EQ(passage.high, signal::filtered(hiss.samples, signal::high_pass(1000.0, hiss.rate, 4)));

    std::vector<double> squares = sums_of(passage.high, part);
    for (double& square : squares)
        square /= static_cast<double>(part);
    EXPECT_EQ(passage.high_squares, squares);

    std::vector<double> levels = sums_of(signal::filtered(hiss.samples, signal::high_pass(100.0, hiss.rate, 2)), 2400);
    for (double& level : levels)
        level /= 2400.0;
    EXPECT_EQ(passage.level_squares, levels);

    ASSERT_EQ(passage.octaves, most_octaves);
    const auto above = signal::filtered(hiss.samples, signal::high_pass(2000.0, hiss.rate, 2));
    const std::vector<double> octave = sums_of(signal::filtered(above, signal::low_pass(4000.0, hiss.rate, 2)), part);
    ASSERT_EQ(passage.octave_squares.size(), octave.size());
    for (std::size_t k = 0; k < octave.size(); ++k)
        EXPECT_EQ(passage.octave_squares[k][1], octave[k]);
}

}  // namespace
}  // namespace stridor::sound
