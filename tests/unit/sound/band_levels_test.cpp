#include "stridor/sound/band_levels.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stridor::sound {
namespace {

using support::sampled;
using support::sine;

constexpr std::size_t part = 96;  // 2 ms

double greatest_rise(const std::vector<double>& levels) {
    double rise = 0.0;
    for (std::size_t k = levels.size() / 10; k + 4 < levels.size(); ++k)
        rise = std::max(rise, levels[k + 4] - levels[k]);
    return rise;
}

TEST(BandLevels, RiseAndFallWithTheGainInAllOctaves) {
    const signal::Signal hiss = support::hiss(1.0);
    signal::Signal louder = hiss;
    for (double& sample : louder.samples)
        sample *= 10.0;
    const std::vector<double> a = band_levels(hiss.samples, hiss.rate, part);
    const std::vector<double> b = band_levels(louder.samples, louder.rate, part);
    ASSERT_EQ(a.size(), hiss.samples.size() / part);
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_NEAR(b[k] - a[k], 20.0, 1e-9);
}

// a tone at 1.5 kHz rings on as in a room; what strikes above is 20 dB weaker: it adds 0.13 dB to the whole level
TEST(BandLevels, ShowWhatStrikesUnderALouderTone) {
    const auto ringing = [](double t) { return sine(1500.0 * t); };
    const auto struck = [&](double t) {
        const double strike = std::exp(-std::fmod(t, 0.1) / 0.005);
        return ringing(t) + 0.1 * strike * (sine(3000.0 * t) + sine(6000.0 * t) + sine(11000.0 * t));
    };
    const auto levels_of = [](const signal::Signal& sound) { return band_levels(sound.samples, sound.rate, part); };
    EXPECT_LT(greatest_rise(levels_of(sampled(1.0, ringing))), 0.5);
    EXPECT_GT(greatest_rise(levels_of(sampled(1.0, struck))), 2.0);
}

TEST(BandLevels, HaveTheOctavesThatTheRateHas) {
    const std::vector<double> samples(1000, 0.1);
    EXPECT_TRUE(band_levels(samples, 2000.0, 4).empty());
    EXPECT_EQ(band_levels(samples, 8000.0, 16).size(), 62u);
}

TEST(BandLevels, OfSilenceAreAllTheSame) {
    const std::vector<double> levels = band_levels(std::vector<double>(4800), 48000.0, part);
    EXPECT_EQ(levels, std::vector<double>(50));
}

}  // namespace
}  // namespace stridor::sound
