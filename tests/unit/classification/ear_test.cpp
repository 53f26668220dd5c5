#include "stridor/classification/ear.hpp"

#include "stridor/classification/ear_weights.hpp"
#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <vector>

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

// clicks 10 to 150 times a second, whose pace glides
TEST(Ear, FindsARowAtAnyPace) {
    for (const double pace : {10.0, 20.0, 50.0, 100.0, 150.0}) {
        std::vector<double> instants;
        for (double t = 0.05; t < 1.9; t += 1.0 / (pace * (1.0 + 0.2 * support::sine(0.7 * t))))
            instants.push_back(t);
        signal::Signal clicks = support::sampled(2.0, [](double) { return 0.0; });
        for (const double instant : instants)
            for (std::size_t n = 0; n < 480; ++n) {
                const double t = static_cast<double>(n) / clicks.rate;
                clicks.samples[static_cast<std::size_t>(instant * clicks.rate) + n] +=
                    std::exp(-t / 0.001) * (support::sine(2100.0 * t) + 0.7 * support::sine(4400.0 * t));
            }
        const EarVerdict verdict = hear(passage_of(signal::with_noise(clicks, 30.0, 5)));
        for (std::size_t k = 0; k < ear_figure_count; ++k)
            if (ear_figures()[k].name == "train") {
                EXPECT_GT(verdict.values[k], 0.7) << pace;
            }
    }
}

// a rig that goes at one speed creaks at one pace: an even row is no music
TEST(Ear, HearsACreakAtOnePace) {
    for (const double pace : {6.0, 12.0, 20.0, 40.0}) {
        std::vector<double> instants;
        for (double t = 0.05; t < 2.9; t += 1.0 / pace)
            instants.push_back(t);
        EXPECT_EQ(heard_in(signal::with_noise(support::struck(3.0, instants), 30.0, 4)), Category::creak) << pace;
    }
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

// noise repeats nowhere: four thuds a second beside it are no tone, whatever the rate
TEST(Ear, HearsNoNoiseInThudsAndHiss) {
    for (const double rate : {8000.0, 16000.0, 48000.0})
        for (const double thud : {1.0, 6.0}) {
            signal::Signal sound = support::hiss(1.0);
            sound.rate = rate;
            sound.samples.resize(static_cast<std::size_t>(rate));
            for (std::size_t n = 0; n < sound.samples.size(); ++n)
                if (std::fmod(static_cast<double>(n) / rate, 0.25) < 0.0025) sound.samples[n] += thud;
            EXPECT_EQ(heard_in(sound), Category::none) << rate << " " << thud;
        }
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
        EXPECT_EQ(p[static_cast<std::size_t>(verdict.rival)], rival);
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

// once a row is found, nothing that it adds to argues for another outcome than a creak
TEST(Ear, LetsRowsArgueForACreakMost) {
    const auto figures = ear_figures();
    constexpr auto creak = static_cast<std::size_t>(EarOutcome::creak);
    for (const std::string_view name : {"train", "jerks", "joint_jerks"}) {
        const auto figure =
            std::find_if(figures.begin(), figures.end(), [&](const EarFigure& f) { return f.name == name; });
        ASSERT_NE(figure, figures.end());
        const auto k = static_cast<std::size_t>(figure - figures.begin());
        for (std::size_t h = 0; h < heard_names.size(); ++h)
            EXPECT_GE(ear_weights[creak][k], ear_weights[h][k]) << name << ", " << heard_names[h];
    }
}

// by hand from the formulas of docs/methods/ear.md
TEST(Ear, TakesItsFiguresByTheirFormulas) {
    sound::Passage passage;
    passage.tones = {.presence = 0.4,
                     .length = 0.18,
                     .wander = 0.5,
                     .spacing = 200.0,
                     .centre = 4000.0,
                     .spread = 0.7,
                     .fundamental = 600.0};
    passage.onsets = {.rate = 14.0,
                      .skewness = 1.0,
                      .train = 0.25,
                      .longest_train = 7.0,
                      .joint_skewness = 3.0,
                      .joint_train = 1.0,
                      .beat = 4.0,
                      .rhythm = 8.0,
                      .kurtosis = 16.0,
                      .level_spread = 3.0,
                      .sounding = 0.9};
    std::map<std::string_view, double> wanted{
        {"tone_presence", 0.4}, {"tone_length", 2.0}, {"tone_wander", 0.5},  {"comb", 1.0},
        {"centre", 2.0},        {"spread", 0.7},      {"onset_rate", 4.0},   {"lone_fundamental", 0.75},
        {"lone_impulses", 3.0}, {"train", 0.25},      {"jerks", 0.5},        {"joint_jerks", 0.25},
        {"beat", 4.0},          {"lone_rhythm", 6.0}, {"level_spread", 3.0}, {"sounding", 0.9}};
    for (const EarFigure& figure : ear_figures())
        EXPECT_NEAR(figure.value(passage), wanted.at(figure.name), 1e-12) << figure.name;
    // half as much of tones: what is said of them counts half
    passage.tones.presence = 0.2;
    wanted["tone_presence"] = 0.2;
    wanted["lone_fundamental"] *= 0.5;
    for (const EarFigure& figure : ear_figures()) {
        const bool is_of_tones = figure.name == "tone_length" || figure.name == "tone_wander" || figure.name == "comb";
        EXPECT_NEAR(figure.value(passage), (is_of_tones ? 0.5 : 1.0) * wanted.at(figure.name), 1e-12) << figure.name;
    }
}

// a penalised fit of probabilities that sum to one has weights that sum to zero: what argues for one argues against
// others
TEST(Ear, HasWeightsThatSumToZeroOverTheOutcomes) {
    constexpr double rounding = 5 * 0.5e-4;  // they are written with four digits
    for (std::size_t k = 0; k < ear_figure_count; ++k) {
        double sum = 0.0;
        for (const auto& weights : ear_weights)
            sum += weights[k];
        EXPECT_NEAR(sum, 0.0, rounding) << ear_figures()[k].name;
    }
    EXPECT_NEAR(std::accumulate(ear_biases.begin(), ear_biases.end(), 0.0), 0.0, rounding);
}

TEST(Ear, NamesEachFigureOnce) {
    std::set<std::string_view> names;
    for (const EarFigure& figure : ear_figures())
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
}

}  // namespace
}  // namespace stridor::classification
