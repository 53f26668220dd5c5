#include "stridor/classification/ear.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>

namespace stridor::classification {
namespace {

sound::Passage passage_of(const signal::Signal& signal) {
    sound::PassageFinder finder(signal.rate);
    finder.push(signal.samples);
    return finder.finish().front();
}

Category heard_in(const signal::Signal& signal) {
    return category_of(hear(passage_of(signal)).heard);
}

TEST(Ear, HearsATextbookCreak) {
    EXPECT_EQ(heard_in(support::creak()), Category::creak);
}

TEST(Ear, HearsAHarmonicToneThatLasts) {
    EXPECT_EQ(heard_in(support::squeal(2.0)), Category::squeal);
}

// chirps of 0.15 s that start, glide, stop and jump: each steady in itself
TEST(Ear, HearsChirpsAsASqueak) {
    const auto chirps = [](double t) {
        const double phase = std::fmod(t, 0.25);
        const double base = 900.0 + 400.0 * std::floor(std::fmod(t / 0.25, 3.0));
        return phase < 0.15 ? support::sine(base * phase + 500.0 * phase * phase) *
                                  (1.0 + 0.5 * support::sine(2.0 * base * phase))
                            : 0.0;
    };
    EXPECT_EQ(heard_in(signal::with_noise(support::sampled(2.0, chirps), 30.0, 2)), Category::squeak);
}

// a rumble at 60 Hz, 20 dB above a tone at 3 kHz, is not what one hears
TEST(Ear, HearsATonePastARumble) {
    const signal::Signal both = support::sampled(
        2.0, [](double t) { return 0.05 * support::sine(3000.0 * t) + 0.5 * support::sine(60.0 * t); });
    EXPECT_EQ(heard_in(signal::with_noise(both, 40.0, 2)), Category::squeal);
}

TEST(Ear, HearsNoNoiseInHiss) {
    EXPECT_EQ(heard_in(support::hiss(3.0)), Category::none);
}

TEST(Ear, GivesProbabilitiesAndReasonsThatAddUp) {
    for (const signal::Signal& signal : {support::creak(), support::squeal(1.0), support::hiss(1.0)}) {
        const EarVerdict verdict = hear(passage_of(signal));
        const auto& p = verdict.probabilities;
        EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
        EXPECT_EQ(p[static_cast<std::size_t>(verdict.heard)], *std::max_element(p.begin(), p.end()));
        // odds are the sum of the reasons and of the difference of two biases, which are no larger than 3
        double rival = 0.0;
        for (std::size_t h = 0; h < p.size(); ++h)
            if (category_of(static_cast<EarOutcome>(h)) != category_of(verdict.heard)) rival = std::max(rival, p[h]);
        const double odds = std::log(p[static_cast<std::size_t>(verdict.heard)] / rival);
        EXPECT_LT(std::abs(std::accumulate(verdict.reasons.begin(), verdict.reasons.end(), 0.0) - odds), 3.0);
    }
}

TEST(Ear, HearsTheSameAtAnyGain) {
    signal::Signal soft = support::creak();
    for (double& sample : soft.samples)
        sample *= 1.0 / 4096.0;
    const EarVerdict loud = hear(passage_of(support::creak()));
    const EarVerdict quiet = hear(passage_of(soft));
    for (std::size_t h = 0; h < heard_names.size(); ++h)
        EXPECT_NEAR(loud.probabilities[h], quiet.probabilities[h], 1e-9);
}

TEST(Ear, NamesEachFigureOnce) {
    std::set<std::string_view> names;
    for (const EarFigure& figure : ear_figures())
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
}

}  // namespace
}  // namespace stridor::classification
