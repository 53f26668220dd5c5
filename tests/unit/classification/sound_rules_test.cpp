#include "stridor/classification/sound_rules.hpp"

#include "stridor/base/error.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/sound/analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stridor::classification {
namespace {

using parameters::SoundThresholds;
using sound::SoundFeatures;
using sound::SoundStretch;

SoundFeatures squeal() {
    SoundFeatures f;
    f.duration = 0.5;
    f.mean_square = 1.0;
    f.clearness = 40.0;
    f.frequency = 900.0;
    f.tonality = 0.9;
    f.regularity = 0.95;
    f.repetition = 0.9;
    f.rest = 0.2;
    f.kurtosis = 1.6;
    f.unsteadiness = 0.1;
    return f;
}

SoundFeatures with(double SoundFeatures::*member, double value) {
    SoundFeatures f = squeal();
    f.*member = value;
    return f;
}

Category heard(const SoundFeatures& f) {
    return classify_sound(f, {}).category;
}

TEST(SoundRules, EachFigureDecidesAtItsThreshold) {
    EXPECT_EQ(heard(squeal()), Category::squeal);
    EXPECT_EQ(heard(with(&SoundFeatures::regularity, 0.8)), Category::squeal);
    EXPECT_EQ(heard(with(&SoundFeatures::regularity, 0.79)), Category::squeak);
    EXPECT_EQ(heard(with(&SoundFeatures::movement, 0.13)), Category::squeak);
    EXPECT_EQ(heard(with(&SoundFeatures::rest, 0.7)), Category::creak);
    EXPECT_EQ(heard(with(&SoundFeatures::kurtosis, 20.0)), Category::creak);
    EXPECT_EQ(heard(with(&SoundFeatures::clearness, -14.1)), Category::none);
    EXPECT_EQ(heard(with(&SoundFeatures::trend, -30.0)), Category::none);
    EXPECT_EQ(heard(with(&SoundFeatures::mean_square, 0.0)), Category::none);
}

// the strongest line is a harmonic of a cycle that comes again exactly: its own cycles are unlike
TEST(SoundRules, ASteadySoundOfManyLinesIsASqueal) {
    SoundFeatures f = with(&SoundFeatures::regularity, 0.3);
    EXPECT_EQ(heard(f), Category::squeak);
    f.repetition = 0.95;
    f.repetition_frequency = 149.6;
    EXPECT_EQ(heard(f), Category::squeal);
    EXPECT_EQ(classify_sound(f, {}).reasons.back(),
              "a steady sound that comes again 149.6 times a second, alike to 0.950, strongest at 900 Hz");
    f.movement = 0.13;
    EXPECT_EQ(heard(f), Category::squeak);
}

TEST(SoundRules, ACrookedFallIsNoFreeVibration) {
    SoundFeatures f = with(&SoundFeatures::trend, -30.0);
    f.unsteadiness = 1.0;
    EXPECT_EQ(heard(f), Category::squeal);
}

TEST(SoundRules, WithoutToneItIsRubbingUnlessImpulsesRepeat) {
    SoundFeatures f = squeal();
    f.tonality = 0.1;
    f.repetition = 0.3;
    EXPECT_EQ(heard(f), Category::none);
    f.impulse_periodicity = 0.5;
    EXPECT_EQ(heard(f), Category::creak);
    EXPECT_EQ(heard(with(&SoundFeatures::frequency, 50.0)), Category::none);
}

TEST(SoundRules, AVerdictListsEveryMarginAndAReason) {
    const SoundVerdict verdict = classify_sound(squeal(), {});
    EXPECT_EQ(verdict.margins.size(), 12u);
    EXPECT_FALSE(verdict.reasons.empty());
    const auto found = std::find_if(verdict.margins.begin(), verdict.margins.end(),
                                    [](const Margin& margin) { return margin.threshold_name == "squeal_regularity"; });
    ASSERT_NE(found, verdict.margins.end());
    EXPECT_NEAR(found->distance, 0.15, 1e-12);
}

SoundStretch stretch(SoundFeatures f, double from) {
    f.from = from;
    return {f, {0.1, 0.2, 0.3, 0.4}};
}

TEST(RecordingRules, NeighboursOfOneCategoryAreOneSegmentAndMostEnergyWins) {
    const SoundFeatures quiet = with(&SoundFeatures::mean_square, 0.1);
    SoundFeatures squeak = quiet;
    squeak.regularity = 0.3;
    const std::vector<SoundStretch> stretches{stretch(squeal(), 0.0), stretch(squeal(), 0.5), stretch(squeak, 1.0)};
    const RecordingVerdict verdict = classify_recording(stretches, {});
    EXPECT_EQ(verdict.category, Category::squeal);
    ASSERT_EQ(verdict.segments.size(), 2u);
    EXPECT_EQ(verdict.segments[0].to, 1.0);
    EXPECT_NEAR(verdict.shares[static_cast<std::size_t>(Category::squeal)], 1.0 / 1.05, 1e-12);
    EXPECT_EQ(verdict.loudest(), &verdict.segments[0]);
}

TEST(RecordingRules, WhatLiesFarBelowTheLoudestIsBackground) {
    const std::vector<SoundStretch> stretches{stretch(squeal(), 0.0),
                                              stretch(with(&SoundFeatures::mean_square, 1e-3), 0.5)};
    const RecordingVerdict verdict = classify_recording(stretches, {});
    EXPECT_EQ(verdict.segments[1].verdict.category, Category::none);
}

TEST(RecordingRules, BackgroundBeginsAtItsDepth) {
    for (const double beyond : {-0.1, 0.1}) {
        const double depth = parameters::SoundThresholds{}.quiet_depth + beyond;
        const SoundFeatures below =
            with(&SoundFeatures::mean_square, squeal().mean_square * std::pow(10.0, -0.1 * depth));
        const std::vector<SoundStretch> stretches{stretch(squeal(), 0.0), stretch(below, 0.5)};
        const SoundVerdict last = classify_recording(stretches, {}).segments.back().verdict;
        EXPECT_EQ(last.category, beyond < 0.0 ? Category::squeal : Category::none);
        EXPECT_EQ(last.reasons.back() == "lies 25.1 dB below the loudest stretch", beyond > 0.0) << last.reasons.back();
    }
}

TEST(RecordingRules, ThinEvidenceIsUndecided) {
    SoundStretch knock = stretch(with(&SoundFeatures::kurtosis, 100.0), 0.0);
    knock.impulses = {0.25};
    EXPECT_EQ(classify_recording(std::vector{knock}, {}).category, Category::undecided);
    const SoundStretch brief = stretch(with(&SoundFeatures::duration, 0.04), 0.0);
    EXPECT_EQ(classify_recording(std::vector{brief}, {}).category, Category::undecided);
    EXPECT_EQ(classify_recording({}, {}).category, Category::undecided);
    EXPECT_EQ(classify_recording(std::vector{stretch(with(&SoundFeatures::mean_square, 0.0), 0.0)}, {}).category,
              Category::none);
}

// a knock: one impulse, heard as creak by its kurtosis
SoundStretch knock_at(double from) {
    SoundStretch one = stretch(with(&SoundFeatures::kurtosis, 100.0), from);
    one.features.duration = 0.1;
    one.impulses = {0.05};
    return one;
}

SoundStretch rest(double from, double duration) {
    SoundStretch silence = stretch(with(&SoundFeatures::mean_square, 0.0), from);
    silence.features.duration = duration;
    silence.impulses.clear();
    return silence;
}

TEST(RecordingRules, KnocksThatComeAgainAfterRestsAreACreak) {
    const std::vector<SoundStretch> thrice{knock_at(0.0), rest(0.1, 0.4), knock_at(0.5), rest(0.6, 0.4), knock_at(1.0)};
    const RecordingVerdict creak = classify_recording(thrice, {});
    EXPECT_EQ(creak.category, Category::creak);
    ASSERT_EQ(creak.segments.size(), 5u);
    EXPECT_EQ(creak.segments[1].verdict.category, Category::none);
    EXPECT_DOUBLE_EQ(creak.segments[2].impulse_interval, 0.5);
    EXPECT_DOUBLE_EQ(creak.segments[2].impulse_regularity, 1.0);
    EXPECT_EQ(creak.segments[2].impulses, std::vector{0.55});
    const RecordingVerdict twice = classify_recording(std::span(thrice).first(3), {});
    EXPECT_EQ(twice.category, Category::undecided);
}

TEST(RecordingRules, KnocksFarApartOrWithANoiseBetweenThemStayKnocks) {
    const std::vector<SoundStretch> far{knock_at(0.0), rest(0.1, 1.5), knock_at(1.6), rest(1.7, 1.5), knock_at(3.2)};
    EXPECT_EQ(classify_recording(far, {}).category, Category::undecided);
    SoundThresholds patient;
    patient.creak_pause = 1.7;
    EXPECT_EQ(classify_recording(far, patient).category, Category::creak);
    const std::vector<SoundStretch> between{knock_at(0.0), stretch(squeal(), 0.1), knock_at(0.6)};
    SoundThresholds two;
    two.least_impulses = 2.0;
    const RecordingVerdict verdict = classify_recording(between, two);
    EXPECT_EQ(verdict.segments.front().verdict.category, Category::undecided);
    EXPECT_EQ(verdict.segments.back().verdict.category, Category::undecided);
}

TEST(RecordingRules, ShortKnocksAreAsLongAsTheirTrain) {
    std::vector<SoundStretch> brief{knock_at(0.0), rest(0.1, 0.3), knock_at(0.4), rest(0.5, 0.3), knock_at(0.8)};
    for (SoundStretch& one : brief)
        if (one.features.mean_square > 0.0) one.features.duration = 0.03;
    EXPECT_EQ(classify_recording(brief, {}).category, Category::creak);
    EXPECT_EQ(classify_recording(std::span(brief).first(1), {}).category, Category::undecided);
}

// a second of it
signal::Signal white_noise(double rate, std::uint64_t seed) {
    signal::Signal knock{rate, "Pa", std::vector<double>(static_cast<std::size_t>(rate))};
    knock.samples.front() = 1.0;
    return signal::with_noise(knock, -200.0, seed);
}

TEST(RecordingRules, WhiteNoiseIsNoNoiseAtAnyRate) {
    for (const double rate : {8000.0, 16000.0, 48000.0}) {
        int noises = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            sound::StretchFinder finder(rate);
            finder.push(white_noise(rate, seed).samples);
            noises += classify_recording(finder.finish(), {}).category != Category::none ? 1 : 0;
        }
        EXPECT_LE(noises, 1) << rate << " Hz";
    }
}

TEST(SoundThresholds, AreSetByNameAndRefusedWithTheNearest) {
    SoundThresholds thresholds;
    parameters::set_sound_threshold(thresholds, "squeal_regularity = 0.7");
    EXPECT_EQ(thresholds.squeal_regularity, 0.7);
    parameters::set_sound_threshold(thresholds, "quiet_depth=30 dB");
    EXPECT_EQ(thresholds.quiet_depth, 30.0);
    parameters::set_sound_threshold(thresholds, "least_duration=20 ms");
    EXPECT_EQ(thresholds.least_duration, 0.02);
    EXPECT_THROW(parameters::set_sound_threshold(thresholds, "squeal_regularity=1.5"), Error);
    EXPECT_THROW(parameters::set_sound_threshold(thresholds, "squeal_regularity"), Error);
    try {
        parameters::set_sound_threshold(thresholds, "squeal_regularty=0.7");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.problem().suggestion, "Did you mean \"squeal_regularity\"?");
    }
}

TEST(Confusion, CountsAndAgrees) {
    Confusion table;
    table = counted(table, Category::squeal, Category::squeal);
    table = counted(table, Category::squeal, Category::squeak);
    table = counted(table, Category::none, Category::none);
    EXPECT_EQ(total(table), 3u);
    EXPECT_NEAR(agreement(table), 2.0 / 3.0, 1e-15);
    EXPECT_EQ(agreement_on(table, Category::squeal), 0.5);
    EXPECT_TRUE(std::isnan(agreement_on(table, Category::creak)));
}

TEST(Confusion, LeavesOutWhatIsUndecidedByTruthOnly) {
    Confusion table;
    EXPECT_TRUE(std::isnan(mean_agreement(table)));
    for (int k = 0; k < 3; ++k)
        table = counted(table, Category::none, Category::none);
    table = counted(table, Category::creak, Category::undecided);
    table = counted(table, Category::undecided, Category::undecided);
    table = counted(table, Category::undecided, Category::squeal);
    const Confusion left = decided(table);
    EXPECT_EQ(total(left), 4u);
    EXPECT_EQ(agreement(left), 0.75);
    // none agrees always, creak never: rare categories weigh as much as frequent ones
    EXPECT_EQ(mean_agreement(left), 0.5);
    EXPECT_EQ(total(sum(table, left)), 10u);
    EXPECT_EQ(agreement(sum(left, left)), 0.75);
}

}  // namespace
}  // namespace stridor::classification
