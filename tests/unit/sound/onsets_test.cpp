#include "stridor/sound/onsets.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace stridor::sound {
namespace {

using support::sampled;
using support::sine;
using support::struck;

Onsets onsets_in(const signal::Signal& signal) {
    return onsets_of(signal.samples, signal.rate);
}

TEST(Onsets, OfACreakAreItsImpulses) {
    const Onsets onsets = onsets_in(support::creak());
    EXPECT_NEAR(static_cast<double>(onsets.instants.size()), 40.0, 2.0);
    EXPECT_NEAR(onsets.instants.front(), 0.1, 0.004);
    EXPECT_GT(onsets.skewness, 1.0);  // up at once, down slowly
    EXPECT_GT(onsets.train, 0.9);
    EXPECT_GT(onsets.longest_train, 30.0);
    EXPECT_GT(onsets.kurtosis, 6.0);
}

TEST(Onsets, FollowEachOtherUnlikeByChance) {
    std::mt19937_64 random(7);
    std::exponential_distribution<double> interval(15.0);
    std::vector<double> instants;
    for (double t = 0.1; t < 4.9; t += interval(random))
        instants.push_back(t);
    EXPECT_LT(onsets_in(struck(5.0, instants)).train, 0.5);
}

TEST(Onsets, OfSteadySoundsAreFew) {
    const Onsets noise = onsets_in(support::hiss(3.0));
    EXPECT_LT(noise.rate, 2.0);
    EXPECT_LT(std::abs(noise.skewness), 0.3);
    EXPECT_NEAR(noise.kurtosis, 3.0, 0.1);
    EXPECT_LT(noise.beat, 1.0);
    EXPECT_LT(onsets_in(support::squeal(3.0)).rate, 2.0);
    EXPECT_NEAR(onsets_in(sampled(1.0, [](double t) { return sine(3000.0 * t); })).kurtosis, 1.5, 0.05);
}

// 70 impulses a second that have died away when the next one comes: steps over 8 ms are the same both ways
TEST(Onsets, OfADenseRowRiseFasterThanTheyFall) {
    const auto row = [](double t) { return std::exp(-std::fmod(t, 1.0 / 70.0) / 0.001) * sine(3000.0 * t); };
    signal::Signal sound = sampled(2.0, row);
    EXPECT_GT(onsets_in(sound).skewness, 0.4);
    std::reverse(sound.samples.begin(), sound.samples.end());
    EXPECT_LT(onsets_in(sound).skewness, 0.1);
}

// reversed, the level rises slowly and falls at once
TEST(Onsets, TellRisesFromFalls) {
    signal::Signal backwards = support::creak();
    std::reverse(backwards.samples.begin(), backwards.samples.end());
    EXPECT_LT(onsets_in(backwards).skewness, -1.0);
}

TEST(Onsets, CountPausesButNotWhatLiesAround) {
    const auto chirps = [](double t) { return t > 1.0 && t < 2.0 && std::fmod(t, 0.4) < 0.2 ? sine(1500.0 * t) : 0.0; };
    EXPECT_NEAR(onsets_in(sampled(3.0, chirps)).sounding, 0.6, 0.11);
    const auto once = [](double t) { return t > 1.0 && t < 2.0 ? sine(1500.0 * t) : 0.0; };
    EXPECT_EQ(onsets_in(sampled(3.0, once)).sounding, 1.0);
}

TEST(Onsets, DoNotDependOnGain) {
    const signal::Signal loud = support::creak();
    signal::Signal soft = loud;
    for (double& sample : soft.samples)
        sample *= 1.0 / 1024.0;
    const Onsets a = onsets_in(loud);
    const Onsets b = onsets_in(soft);
    EXPECT_EQ(a.instants, b.instants);
    EXPECT_NEAR(a.skewness, b.skewness, 1e-9);
    EXPECT_NEAR(a.beat, b.beat, 1e-9);
    EXPECT_NEAR(a.level_spread, b.level_spread, 1e-9);
}

TEST(Onsets, OfSilenceAreNone) {
    const Onsets onsets = onsets_in(sampled(0.5, [](double) { return 0.0; }));
    EXPECT_TRUE(onsets.instants.empty());
    EXPECT_EQ(onsets.kurtosis, 0.0);
    EXPECT_EQ(onsets.rate, 0.0);
}

TEST(Onsets, AreFoundAtLowRates) {
    const signal::Signal low{2000.0, signal::full_scale, std::vector<double>(1000, 0.1)};
    EXPECT_TRUE(std::isfinite(onsets_in(low).level_spread));
}

// a dry creak: clicks of 0.3 ms at a pace that glides around `pace` [1/s], over noise
signal::Signal dry_creak(double pace) {
    std::vector<double> instants;
    for (double t = 0.05; t < 1.9; t += 1.0 / (pace * (1.0 + 0.2 * sine(0.7 * t))))
        instants.push_back(t);
    signal::Signal clicks = sampled(2.0, [](double) { return 0.0; });
    for (const double instant : instants)
        for (std::size_t n = 0; n < 14; ++n)
            clicks.samples[static_cast<std::size_t>(instant * clicks.rate) + n] += n % 2 == 0 ? 1.0 : -1.0;
    return signal::with_noise(clicks, 25.0, 5);
}

TEST(Onsets, AreFoundAtThePaceTheyHave) {
    for (const double pace : {40.0, 80.0, 120.0, 180.0}) {
        const signal::Signal sound = dry_creak(pace);
        const Onsets onsets = onsets_of(sound.samples, sound.rate);
        EXPECT_NEAR(onsets.fast_rate, pace, 0.15 * pace);
        EXPECT_GT(onsets.fast_train, 0.85) << pace;
        EXPECT_GT(onsets.longest_fast_train, 0.5 * pace) << pace;
    }
}

TEST(Onsets, OfHissMakeNoFastRow) {
    const signal::Signal hiss = support::hiss(3.0);
    EXPECT_LT(onsets_of(hiss.samples, hiss.rate).fast_train, 0.1);
}

}  // namespace
}  // namespace stridor::sound
