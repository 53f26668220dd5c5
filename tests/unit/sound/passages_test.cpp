#include "stridor/sound/passages.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

namespace stridor::sound {
namespace {

// pushed in blocks of so many samples
std::vector<Passage> passages_of(const signal::Signal& signal, std::size_t block) {
    PassageFinder finder(signal.rate);
    const std::span<const double> samples(signal.samples);
    for (std::size_t first = 0; first < samples.size(); first += block)
        finder.push(samples.subspan(first, std::min(block, samples.size() - first)));
    return finder.finish();
}

std::vector<double> durations(double seconds) {
    std::vector<double> found;
    for (const Passage& passage : passages_of(support::hiss(seconds), 48000))
        found.push_back(passage.duration);
    return found;
}

TEST(Passages, LastThreeSecondsAndTheLastUpToFour) {
    EXPECT_EQ(durations(0.5), (std::vector{0.5}));
    EXPECT_EQ(durations(4.0), (std::vector{4.0}));
    EXPECT_EQ(durations(6.5), (std::vector{3.0, 3.5}));
    EXPECT_EQ(durations(7.5), (std::vector{3.0, 3.0, 1.5}));
    EXPECT_TRUE(durations(0.01).empty());
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

TEST(Passages, TellInstantsOfTheRecording) {
    signal::Signal sound = support::hiss(3.0);
    for (double& sample : sound.samples)
        sample *= 1e-3;
    const signal::Signal creak = support::creak();
    sound.samples.insert(sound.samples.end(), creak.samples.begin(), creak.samples.end());
    const std::vector<Passage> passages = passages_of(sound, 4800);
    ASSERT_EQ(passages.size(), 2U);
    EXPECT_NEAR(passages[1].onsets.instants.front(), 3.1, 0.005);
    EXPECT_GT(passages[1].tones.pitch.empty() ? 3.0 : passages[1].tones.pitch.front().time, 2.99);
}

}  // namespace
}  // namespace stridor::sound
