#include "stridor/sound/passages.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <span>
#include <vector>

namespace stridor::sound {
namespace {

// what a finder finds in a signal that is pushed in blocks of so many samples
template <typename Finder>
auto found_by(const signal::Signal& signal, std::size_t block) {
    Finder finder(signal.rate);
    const std::span<const double> samples(signal.samples);
    for (std::size_t first = 0; first < samples.size(); first += block)
        finder.push(samples.subspan(first, std::min(block, samples.size() - first)));
    return finder.finish();
}

std::vector<Passage> passages_of(const signal::Signal& signal, std::size_t block) {
    return found_by<PassageFinder>(signal, block);
}

std::vector<SoundStretch> stretches_of(const signal::Signal& signal, std::size_t block) {
    return found_by<StretchFinder>(signal, block);
}

std::vector<double> durations(const signal::Signal& signal) {
    std::vector<double> found;
    for (const Passage& passage : passages_of(signal, 48000))
        found.push_back(passage.duration);
    return found;
}

signal::Signal joined(std::initializer_list<signal::Signal> parts) {
    signal::Signal whole{parts.begin()->rate, signal::full_scale, {}};
    for (const signal::Signal& part : parts)
        whole.samples.insert(whole.samples.end(), part.samples.begin(), part.samples.end());
    return whole;
}

signal::Signal softer(signal::Signal signal, double decibels) {
    for (double& sample : signal.samples)
        sample *= std::pow(10.0, -decibels / 20.0);
    return signal;
}

TEST(Passages, LastUpToFourSeconds) {
    EXPECT_EQ(durations(support::hiss(0.5)).size(), 1U);
    EXPECT_EQ(durations(support::hiss(4.0)).size(), 1U);
    const std::vector<double> parted = durations(support::hiss(12.0));
    EXPECT_GE(parted.size(), 3U);
    EXPECT_NEAR(std::accumulate(parted.begin(), parted.end(), 0.0), 12.0, 0.02);
    for (const double duration : parted) {
        EXPECT_GE(duration, 0.5);
        EXPECT_LE(duration, 4.01);
    }
    EXPECT_TRUE(durations(support::hiss(0.01)).empty());
}

TEST(Passages, AreWhereTheSoundIs) {
    const signal::Signal room = softer(support::hiss(1.3), 50.0);
    const std::vector<Passage> found =
        passages_of(joined({room, support::squeal(1.0), room, support::squeal(0.7), room}), 5000);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].from, 1.3, 0.003);
    EXPECT_NEAR(found[0].duration, 1.0, 0.01);
    EXPECT_NEAR(found[1].from, 3.6, 0.003);
    EXPECT_NEAR(found[1].duration, 0.7, 0.01);
}

// what is heard of a squeak between whose chirps it rests is one passage
TEST(Passages, KeepShortPausesWithinASound) {
    const signal::Signal rest = softer(support::hiss(0.4), 60.0);
    EXPECT_EQ(durations(joined({support::squeal(0.3), rest, support::squeal(0.3), rest, support::squeal(0.3)})).size(),
              1U);
}

// a pause of any length in front leaves what the passages say of the sound
TEST(Passages, AreNotChangedByAPause) {
    for (const signal::Signal& sound : {support::creak(), support::squeal(2.0)}) {
        const Passage usual = passages_of(sound, 4096).front();
        for (const double pause : {0.123, 0.7, 5.0})
            for (const double depth : {50.0, 400.0}) {
                const signal::Signal room = softer(support::hiss(pause), depth);
                const std::vector<Passage> all = passages_of(joined({room, sound, room}), 4096);
                // a room alone for more than 4 s is a passage of its own
                const auto found = std::max_element(all.begin(), all.end(), [](const Passage& a, const Passage& b) {
                    return a.tones.mean_square < b.tones.mean_square;
                });
                ASSERT_NE(found, all.end());
                EXPECT_NEAR(found->duration, usual.duration, 0.02);
                EXPECT_NEAR(found->tones.presence, usual.tones.presence, 0.02);
                EXPECT_NEAR(found->onsets.train, usual.onsets.train, 0.05);
                EXPECT_NEAR(found->onsets.beat, usual.onsets.beat, 0.2);
                EXPECT_NEAR(std::log2(found->onsets.kurtosis), std::log2(usual.onsets.kurtosis), 0.1);
            }
    }
}

TEST(Passages, AreTheSameInBlocksOfAnySize) {
    signal::Signal sound = support::creak();
    const signal::Signal tone = support::squeal(4.0);
    sound.samples.insert(sound.samples.end(), tone.samples.begin(), tone.samples.end());
    const std::vector<Passage> whole = passages_of(sound, sound.samples.size());
    const std::vector<Passage> parts = passages_of(sound, 1777);
    ASSERT_EQ(whole.size(), parts.size());
    for (std::size_t k = 0; k < whole.size(); ++k) {
        EXPECT_EQ(whole[k].from, parts[k].from);
        EXPECT_EQ(whole[k].tones.mean_square, parts[k].tones.mean_square);
        EXPECT_EQ(whole[k].tones.presence, parts[k].tones.presence);
        EXPECT_EQ(whole[k].onsets.instants, parts[k].onsets.instants);
        EXPECT_EQ(whole[k].onsets.beat, parts[k].onsets.beat);
    }
}

// the loud tone lies ahead of the soft hiss, in the same block or in a later one
TEST(Stretches, AreTheSameInBlocksOfAnySize) {
    const signal::Signal hiss = softer(support::hiss(0.4), 70.0);
    const signal::Signal softer_hiss = softer(support::hiss(0.4), 80.0);
    const signal::Signal sound =
        joined({hiss, softer_hiss, hiss, softer_hiss, hiss, support::squeal(1.0), softer_hiss, hiss, softer_hiss});
    const std::vector<SoundStretch> whole = stretches_of(sound, sound.samples.size());
    ASSERT_GT(whole.size(), 8U);
    for (const std::size_t block : {1U, 480U, 4800U, 65536U}) {
        const std::vector<SoundStretch> parts = stretches_of(sound, block);
        ASSERT_EQ(whole.size(), parts.size()) << block;
        for (std::size_t k = 0; k < whole.size(); ++k) {
            EXPECT_EQ(whole[k].features.from, parts[k].features.from) << block;
            EXPECT_EQ(whole[k].features.duration, parts[k].features.duration) << block;
            EXPECT_EQ(whole[k].features.mean_square, parts[k].features.mean_square) << block;
        }
    }
}

TEST(Passages, TellInstantsOfTheRecording) {
    const std::vector<Passage> passages =
        passages_of(joined({softer(support::hiss(3.0), 60.0), support::creak()}), 4800);
    ASSERT_EQ(passages.size(), 1U);
    EXPECT_NEAR(passages[0].onsets.instants.front(), 3.1, 0.1);
    EXPECT_GT(passages[0].from, 2.99);
}

// all is silent: there is a passage to say so
TEST(Passages, OfSilenceAreOne) {
    const std::vector<Passage> passages = passages_of(support::sampled(9.0, [](double) { return 0.0; }), 4800);
    ASSERT_EQ(passages.size(), 1U);
    EXPECT_EQ(passages[0].tones.mean_square, 0.0);
}

}  // namespace
}  // namespace stridor::sound
