#include "stridor/sound/features.hpp"

#include "stridor/base/error.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/sound/analysis.hpp"
#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stridor::sound {
namespace {

using support::sampled;
using support::sine;
using support::sound_rate;

TEST(SoundFeatures, ASteadyToneIsAllInOneLineAndRegular) {
    const SoundFeatures f = sound_features(sampled(0.5, [](double t) { return 0.3 * sine(1000.0 * t); }));
    EXPECT_NEAR(f.frequency, 1000.0, 1.0);
    EXPECT_GT(f.tonality, 0.99);
    EXPECT_GT(f.regularity, 0.99);
    EXPECT_LT(f.movement, 1e-3);
    EXPECT_NEAR(f.mean_square, 0.045, 0.0005);
    EXPECT_NEAR(f.kurtosis, 1.5, 0.01);
    EXPECT_NEAR(f.crest, std::sqrt(2.0), 0.02);
    EXPECT_NEAR(f.trend, 0.0, 0.1);
}

TEST(SoundFeatures, AFreeVibrationFallsAlongAStraightLine) {
    const SoundFeatures f = sound_features(sampled(0.5, [](double t) { return std::exp(-4.0 * t) * sine(600.0 * t); }));
    EXPECT_NEAR(f.trend, -20.0 * 4.0 / std::log(10.0), 0.2);  // 34.7 dB/s
    EXPECT_LT(f.unsteadiness, 0.02);
}

TEST(SoundFeatures, StickSlipRestsForTheShareItSticks) {
    // a velocity that stays at V for 80 % of each 5 ms period and swings out for the rest
    const SoundFeatures f = sound_features(sampled(0.5, [](double t) {
        const double phase = 200.0 * t - std::floor(200.0 * t);
        return phase < 0.8 ? 0.1 : 0.1 - 0.4 * sine((phase - 0.8) / 0.4);
    }));
    EXPECT_NEAR(f.rest, 0.8, 0.05);
    EXPECT_GT(f.repetition, 0.95);
    EXPECT_NEAR(f.repetition_frequency, 200.0, 2.0);
}

TEST(SoundFeatures, NoiseHasNoToneNoImpulsesAndLittleClearness) {
    signal::Signal signal = sampled(0.5, [](double t) { return t < 0.5 / sound_rate ? 1e-9 : 0.0; });
    signal = signal::with_noise(signal, -100.0, 11);
    const SoundFeatures f = sound_features(signal);
    EXPECT_LT(f.clearness, -20.0);
}

TEST(SoundFeatures, GainDoesNotMatter) {
    const signal::Signal signal =
        signal::with_noise(sampled(0.3, [](double t) { return sine(700.0 * t) + 0.3 * sine(1150.0 * t); }), 20.0, 5);
    const SoundFeatures one = sound_features(signal);
    const SoundFeatures other = sound_features(signal::amplified(signal, -80.0));
    EXPECT_NEAR(one.regularity, other.regularity, 1e-9);
    EXPECT_NEAR(one.rest, other.rest, 2e-3);
    EXPECT_NEAR(one.kurtosis, other.kurtosis, 1e-9);
    EXPECT_NEAR(one.tonality, other.tonality, 1e-9);
}

TEST(SoundFeatures, AToneThatMovesIsSeenToMove) {
    const SoundFeatures f =
        sound_features(sampled(0.5, [](double t) { return sine(1000.0 * t + 400.0 * t * t); }));  // 1000 to 1400 Hz
    EXPECT_GT(f.movement, 0.05);
}

TEST(SoundFeatures, ImpulsesThatRepeatAreFound) {
    const SoundFeatures f = sound_features(sampled(0.5, [](double t) {
        const double phase = t - 0.02 * std::floor(t / 0.02);
        return std::exp(-400.0 * phase) * sine(2000.0 * phase);
    }));
    EXPECT_NEAR(f.impulse_interval, 0.02, 0.0006);
    EXPECT_GT(f.impulse_periodicity, 0.9);
    EXPECT_NEAR(static_cast<double>(f.impulses), 24.0, 2.0);  // the ends fade out under the window
}

TEST(SoundFeatures, SilenceHasNoFigures) {
    const SoundFeatures f = sound_features(sampled(0.1, [](double) { return 0.25; }));
    EXPECT_EQ(f.frequency, 0.0);
    EXPECT_LT(f.mean_square, 1e-25);
}

TEST(SoundFeatures, TooShortASoundIsRefused) {
    EXPECT_THROW(sound_features(sampled(0.01, [](double) { return 0.0; })), Error);
}

TEST(Analyse, BlocksDoNotMatter) {
    const signal::Signal signal = signal::with_noise(
        sampled(2.3, [](double t) { return t < 1.0 ? sine(800.0 * t) : 0.01 * sine(500.0 * t); }), 40.0, 2);
    const auto analysed = [&](std::size_t block) {
        StretchFinder finder(sound_rate);
        ChannelOverview overview(sound_rate, {"", "m/s"});
        for (std::size_t first = 0; first < signal.samples.size(); first += block) {
            const auto samples =
                std::span(signal.samples).subspan(first, std::min(block, signal.samples.size() - first));
            finder.push(samples);
            overview.meter().push(samples);
            overview.push(samples);
        }
        SoundAnalysis analysis = overview.finish();
        analysis.stretches = finder.finish();
        return analysis;
    };
    const SoundAnalysis one = analysed(signal.samples.size());
    const SoundAnalysis other = analysed(777);
    ASSERT_EQ(one.stretches.size(), other.stretches.size());
    for (std::size_t k = 0; k < one.stretches.size(); ++k) {
        EXPECT_EQ(one.stretches[k].features.from, other.stretches[k].features.from);
        EXPECT_EQ(one.stretches[k].features.regularity, other.stretches[k].features.regularity);
    }
    EXPECT_EQ(one.spectrum.density, other.spectrum.density);
    EXPECT_EQ(one.level.decibels, other.level.decibels);
}

TEST(Analyse, StretchesEndWhereTheLevelJumps) {
    const signal::Signal signal =
        sampled(0.6, [](double t) { return (t < 0.2 || t > 0.4 ? 1.0 : 0.05) * sine(800.0 * t); });
    auto source = signal::source_of({signal});
    const auto analysis = analyse(*source).front();
    ASSERT_EQ(analysis.stretches.size(), 3u);
    EXPECT_NEAR(analysis.stretches[1].features.from, 0.2, 0.011);
    EXPECT_NEAR(analysis.stretches[2].features.from, 0.4, 0.011);
    EXPECT_NEAR(analysis.duration, 0.6, 1e-9);
}

TEST(Analyse, ChannelsAreAnalysedEachByItself) {
    const signal::Signal tone = sampled(0.3, [](double t) { return sine(800.0 * t); });
    const signal::Signal other = sampled(0.3, [](double t) { return sine(1200.0 * t); });
    auto both = signal::source_of({tone, other});
    const auto analyses = analyse(*both);
    ASSERT_EQ(analyses.size(), 2u);
    auto alone = signal::source_of({other});
    EXPECT_EQ(analyses[1].spectrum.density, analyse(*alone).front().spectrum.density);
}

TEST(Analyse, TheOrderOfItsPiecesDoesNotMatter) {
    const signal::Signal signal = signal::with_noise(sampled(4.0, [](double t) { return sine(800.0 * t); }), 40.0, 3);
    const Runner backwards = [](std::size_t count, const std::function<void(std::size_t)>& work) {
        for (std::size_t k = count; k-- > 0;)
            work(k);
    };
    auto source = signal::source_of({signal, signal});
    const auto usual = analyse(*source);
    source = signal::source_of({signal, signal});
    const auto other = analyse(*source, {}, backwards);
    EXPECT_EQ(usual[1].spectrum.density, other[1].spectrum.density);
    EXPECT_EQ(usual[1].duration, other[1].duration);
    ASSERT_EQ(usual[1].stretches.size(), other[1].stretches.size());
    for (std::size_t k = 0; k < usual[1].stretches.size(); ++k)
        EXPECT_EQ(usual[1].stretches[k].features.clearness, other[1].stretches[k].features.clearness);
}

TEST(Analyse, SaysWhichSampleOfALongRecordingIsNoNumber) {
    signal::Signal signal = sampled(4.0, [](double t) { return sine(800.0 * t); });
    signal.samples[150000] = std::numeric_limits<double>::infinity();
    auto source = signal::source_of({signal});
    try {
        analyse(*source);
        FAIL() << "an infinite sample passed";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("sample 150001"), std::string::npos) << error.what();
    }
}

TEST(Analyse, RefusesNothingAndWhatIsNoNumber) {
    auto empty = signal::source_of({signal::Signal{sound_rate, "FS", {}}});
    EXPECT_THROW(analyse(*empty), Error);
    auto broken =
        signal::source_of({signal::Signal{sound_rate, "FS", {0.0, std::numeric_limits<double>::quiet_NaN()}}});
    EXPECT_THROW(analyse(*broken), Error);
    auto slow = signal::source_of({signal::Signal{1.0, "FS", {0.0, 1.0, 0.0}}});
    EXPECT_THROW(analyse(*slow), Error);
}

}  // namespace
}  // namespace stridor::sound
