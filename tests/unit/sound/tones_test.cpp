#include "stridor/sound/tones.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using stridor::sound::parabola_summit;
using stridor::sound::Summit;

namespace {

RC_GTEST_PROP(Parabola, HasItsSummitWhereItIs, ()) {
    const double place = *rc::gen::inRange(-500, 501) * 1e-3;
    const double height = *rc::gen::inRange(-1000, 1001) * 1e-2;
    const double bend = *rc::gen::inRange(1, 1000) * 1e-2;
    const auto value = [&](double x) { return height - bend * (x - place) * (x - place); };
    const Summit summit = parabola_summit(value(-1.0), value(0.0), value(1.0));
    RC_ASSERT(std::abs(summit.place - place) < 1e-9);
    RC_ASSERT(std::abs(summit.height - height) < 1e-9);
}

TEST(Parabola, IsTheMiddleValueWhereNothingBendsDown) {
    for (const Summit summit : {parabola_summit(1.0, 1.0, 1.0), parabola_summit(2.0, 1.0, 3.0)}) {
        EXPECT_EQ(summit.place, 0.0);
        EXPECT_EQ(summit.height, 1.0);
    }
}

TEST(Parabola, StaysWithinHalfAStep) {
    EXPECT_EQ(parabola_summit(0.0, 1.0, 1.9).place, 0.5);
}

}  // namespace

namespace stridor::sound {
namespace {

using support::sampled;
using support::sine;

Tones tones_of(const signal::Signal& signal) {
    return ToneFinder(signal.rate).find(signal.samples);
}

TEST(Tones, OfASineHoldItsPower) {
    const Tones tones = tones_of(sampled(1.0, [](double t) { return sine(1000.0 * t); }));
    EXPECT_NEAR(tones.mean_square, 0.5, 0.01);
    EXPECT_GT(tones.presence, 0.95);
    EXPECT_NEAR(tones.length, 1.0, 0.1);
    EXPECT_LT(tones.wander, 0.01);
    EXPECT_NEAR(tones.centre, 1000.0, 5.0);
    EXPECT_LT(tones.spread, 0.1);
    ASSERT_FALSE(tones.pitch.empty());
    for (const TonePoint& point : tones.pitch)
        EXPECT_NEAR(point.frequency, 1000.0, 2.0);
}

// 20 dB at 100 Hz count as much as 1 dB at 1 kHz: A-weighting, -19.1 dB there
TEST(Tones, WeighPowerAsTheEarDoes) {
    const Tones low = tones_of(sampled(1.0, [](double t) { return sine(100.0 * t); }));
    EXPECT_NEAR(10.0 * std::log10(low.mean_square / 0.5), -19.1, 0.3);
}

TEST(Tones, KeepGlidingHarmonics) {
    // 600 to 900 Hz in a second, ten harmonics
    const Tones tones = tones_of(sampled(1.0, [](double t) {
        double sum = 0.0;
        for (int k = 1; k <= 10; ++k)
            sum += sine(k * (600.0 * t + 150.0 * t * t)) / k;
        return sum;
    }));
    EXPECT_GT(tones.presence, 0.9);
    EXPECT_GT(tones.wander, 0.1);
    EXPECT_NEAR(tones.spacing, 750.0, 60.0);
}

TEST(Tones, FindTheSpacingOfAVoice) {
    const Tones tones = tones_of(sampled(1.0, [](double t) {
        double sum = 0.0;
        for (int k = 1; k <= 30; ++k)
            sum += sine(180.0 * k * t) / std::sqrt(k);
        return sum;
    }));
    EXPECT_NEAR(tones.spacing, 180.0, 5.0);
}

TEST(Tones, AreNotInNoise) {
    const Tones tones = tones_of(support::hiss(3.0));
    EXPECT_LT(tones.presence, 0.05);
    EXPECT_LT(static_cast<double>(tones.pitch.size()), 0.1 * 3.0 * 47.0);
}

TEST(Tones, DoNotDependOnGain) {
    const signal::Signal loud = support::squeal(0.7);
    signal::Signal soft = loud;
    for (double& sample : soft.samples)
        sample *= 0.001;
    const Tones a = tones_of(loud);
    const Tones b = tones_of(soft);
    EXPECT_NEAR(a.presence, b.presence, 1e-9);
    EXPECT_NEAR(a.length, b.length, 1e-9);
    EXPECT_NEAR(a.wander, b.wander, 1e-9);
    EXPECT_NEAR(a.centre, b.centre, 1e-6);
    EXPECT_NEAR(a.mean_square * 1e-6, b.mean_square, 1e-12 * a.mean_square);
}

TEST(Tones, OfSilenceAndOfAMomentAreNone) {
    const Tones silence = tones_of(sampled(0.5, [](double) { return 0.0; }));
    EXPECT_EQ(silence.mean_square, 0.0);
    EXPECT_EQ(silence.presence, 0.0);
    EXPECT_EQ(silence.centre, 0.0);
    EXPECT_EQ(tones_of(sampled(0.02, [](double t) { return sine(900.0 * t); })).length, 0.0);
}

// a voice of 120 Hz, whatever its harmonics weigh, under a rumble of 50 Hz, ten times as strong
TEST(Tones, HaveTheFundamentalOfAVoice) {
    for (const double slope : {0.5, 1.0, 2.0}) {
        const Tones tones = tones_of(sampled(1.0, [&](double t) {
            double sum = 10.0 * sine(50.0 * t);
            for (int k = 1; k <= 20; ++k)
                sum += sine(120.0 * k * t) / std::pow(k, slope);
            return sum;
        }));
        EXPECT_NEAR(tones.fundamental, 120.0, 2.0) << slope;
    }
}

TEST(Tones, OfSilenceHaveNoFundamental) {
    EXPECT_EQ(ToneFinder(48000.0).find(std::vector<double>(48000)).fundamental, 0.0);
    EXPECT_EQ(ToneFinder(100.0).find(std::vector<double>(100, 1.0)).fundamental, 0.0);
}

}  // namespace
}  // namespace stridor::sound
