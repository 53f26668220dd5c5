#include "stridor/sound/tracks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace stridor::sound {
namespace {

// one passage each second with a point and an onset each hundredth
SoundAnalysis busy_channel() {
    SoundAnalysis channel;
    channel.duration = 10.0;
    for (int second = 0; second < 10; ++second) {
        Passage passage;
        for (int k = 0; k < 100; ++k) {
            const double time = second + 0.01 * k + 0.005;
            passage.tones.pitch.push_back({time, 1000.0 + k});
            passage.onsets.instants.push_back(time);
        }
        channel.passages.push_back(passage);
    }
    return channel;
}

}  // namespace

TEST(Tracks, KeepAllThatAPictureCanShow) {
    EXPECT_EQ(pitch_track(busy_channel(), 1000).size(), 1000U);
    EXPECT_EQ(onset_track(busy_channel(), 1000).size(), 1000U);
}

TEST(Tracks, KeepOneOfEachMomentOfWhatIsMore) {
    const std::vector<TonePoint> pitch = pitch_track(busy_channel(), 10);
    ASSERT_EQ(pitch.size(), 10U);
    EXPECT_DOUBLE_EQ(pitch[3].frequency, 1050.0) << "the median of its second";
    const std::vector<double> onsets = onset_track(busy_channel(), 10);
    ASSERT_EQ(onsets.size(), 10U);
    EXPECT_NEAR(onsets[3], 3.005, 1e-9) << "the first of its second";
}

TEST(Tracks, LeaveOutThePitchOfWhatIsHardlyHeard) {
    SoundAnalysis channel = busy_channel();
    channel.level.interval = 5.0;
    channel.level.decibels = {-60.0, -20.0};
    channel.level.greatest = -20.0;
    const std::vector<TonePoint> pitch = pitch_track(channel, 1000);
    ASSERT_EQ(pitch.size(), 500U);
    EXPECT_GT(pitch.front().time, 5.0);
}

TEST(Passages, KeepTheLoudestThroughShortFrames) {
    constexpr double rate = 8000.0;
    std::vector<double> samples(static_cast<std::size_t>(8.0 * rate));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double time = static_cast<double>(n) / rate;
        samples[n] = (time >= 4.4 && time < 4.7 ? 0.1 : 1e-3) * std::sin(2.0 * std::numbers::pi * 1000.0 * time);
    }
    samples[static_cast<std::size_t>(4.5 * rate)] = 0.9;
    PassageFinder finder(rate);
    finder.push(samples);
    // what is 40 dB softer is a pause for 4 s around
    ASSERT_EQ(finder.finish().size(), 2U);
    const signal::Spectrogram& graph = finder.impulses();
    EXPECT_NEAR(graph.from, 4.4, 0.01);
    EXPECT_NEAR(graph.from + graph.column * static_cast<double>(graph.columns()), 4.7, 0.02);
    EXPECT_LE(graph.column, 0.005);
    std::size_t loudest = 0;
    for (std::size_t column = 0; column < graph.columns(); ++column)
        if (graph.density[(column + 1) * graph.rows - 1] > graph.density[(loudest + 1) * graph.rows - 1])
            loudest = column;
    EXPECT_NEAR(graph.from + (static_cast<double>(loudest) + 0.5) * graph.column, 4.5, graph.column);
}

TEST(Passages, HaveNoShortFramesOfSilence) {
    PassageFinder finder(8000.0);
    finder.push(std::vector<double>(40000));
    finder.finish();
    EXPECT_EQ(finder.impulses().columns(), 0U);
}

}  // namespace stridor::sound
