// A sound that is not over by ear: what is told does not depend on how it comes, and is what a recording of it gets.

#include "stridor/hearing/live_ear.hpp"

#include "stridor/hearing/sound_ring.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stridor::hearing {

namespace {

using classification::Category;

constexpr double rate = 16000.0;  // [Hz]

double turn(double turns) {
    return std::sin(2.0 * std::numbers::pi * turns);
}

// A squeal from 5 to 8 s and a creak from 20 to 23 s in soft noise: left; right has the noise and half of the squeal.
std::vector<double> two_channels(double duration) {
    support::CounterRandom random(7);
    std::vector<double> frames;
    for (std::size_t n = 0; n < static_cast<std::size_t>(duration * rate); ++n) {
        const double t = static_cast<double>(n) / rate;
        const auto noise = [&] { return 1e-3 * (static_cast<double>(random.next() >> 11U) * 0x1p-52 - 1.0); };
        double squeal = 0.0;
        for (int k = 1; k <= 8; ++k)
            squeal += t >= 5.0 && t < 8.0 ? 0.1 * turn(700.0 * k * t) / k : 0.0;
        const double since = std::fmod(t, 0.06);
        const double creak = t >= 20.0 && t < 23.0
                                 ? 0.5 * std::exp(-since / 0.006) * (turn(2100.0 * since) + turn(3400.0 * since))
                                 : 0.0;
        frames.push_back(squeal + creak + noise());
        frames.push_back(0.5 * squeal + noise());
    }
    return frames;
}

const std::vector<double>& drive() {
    static const std::vector<double> frames = two_channels(34.0);
    return frames;
}

signal::ChannelLayout stereo(const std::string& unit = signal::full_scale) {
    return {rate, {{"left", unit}, {"right", unit}}, {}};
}

class Frames final : public signal::Source {
public:
    explicit Frames(std::span<const double> frames, signal::ChannelLayout layout)
        : frames_(frames),
          layout_(std::move(layout)) {}
    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> into) override {
        const std::size_t count = std::min(into.size(), frames_.size());
        std::copy_n(frames_.begin(), count, into.begin());
        frames_ = frames_.subspan(count);
        return count / layout_.channels.size();
    }

private:
    std::span<const double> frames_;
    signal::ChannelLayout layout_;
};

std::string verdict_words(const classification::RecordingVerdict& verdict) {
    std::string text = fmt::format("{} {} {}", classification::name(verdict.category), verdict.probability,
                                   fmt::join(verdict.reasons, "; "));
    for (const classification::SoundSegment& segment : verdict.segments)
        text += fmt::format("\n  {} {} {} {} {}", segment.from, segment.to, segment.mean_square,
                            classification::name(segment.verdict.category), segment.verdict.features.frequency);
    for (const classification::HeardPassage& passage : verdict.passages)
        text += fmt::format("\n  {} {} {} {}", passage.from, passage.to, passage.energy,
                            fmt::join(passage.ear.values, " "));
    return text;
}

struct Told {
    std::vector<LivePassage> passages{};
    std::vector<LiveNoise> noises{};
    std::vector<std::vector<double>> clips{};
    std::vector<LiveTake> takes{};
    std::string words{};  // all of it, in its order and to the last digit
};

LiveListener listener_to(Told& told) {
    return {[&](const LivePassage& passage) {
                told.words += fmt::format("passage {} {} {} {} {} {} {}\n", passage.channel, passage.from, passage.to,
                                          passage.level, passage.frequency, passage.is_background,
                                          verdict_words(passage.verdict));
                told.passages.push_back(passage);
            },
            [&](const LiveNoise& noise, signal::Source& clip) {
                std::vector<double> frames(10'000'000);
                frames.resize(clip.read(frames) * clip.layout().channels.size());
                told.words += fmt::format("noise {} {} {} {} {} {}\n", noise.number, noise.from, noise.to,
                                          noise.clip_from, noise.clip_to, frames.size());
                told.noises.push_back(noise);
                told.clips.push_back(std::move(frames));
            },
            [&](const LiveTake& take) {
                told.words +=
                    fmt::format("take {} {} {} {}\n", take.number, take.from, take.to, static_cast<int>(take.why));
                for (const classification::RecordingVerdict& verdict : take.verdicts)
                    told.words += verdict_words(verdict) + "\n";
                told.takes.push_back(take);
            }};
}

Told heard(std::span<const double> frames, std::size_t piece, const LiveEarOptions& options = {},
           const signal::ChannelLayout& layout = stereo()) {
    Told told;
    LiveEar ear(layout, options, listener_to(told));
    for (std::size_t k = 0; k < frames.size(); k += piece)
        ear.push(frames.subspan(k, std::min(piece, frames.size() - k)));
    ear.finish();
    return told;
}

const Told& heard_at_once() {
    static const Told told = heard(drive(), drive().size());
    return told;
}

std::vector<std::string> verdicts_of_recording(std::span<const double> frames,
                                               const signal::ChannelLayout& layout = stereo()) {
    Frames source(frames, layout);
    std::vector<std::string> words;
    for (const sound::SoundAnalysis& channel : sound::analyse(source))
        words.push_back(verdict_words(classification::verdict_on(channel, {})));
    return words;
}

std::vector<std::string> verdicts_of_take(const LiveTake& take) {
    std::vector<std::string> words;
    for (const classification::RecordingVerdict& verdict : take.verdicts)
        words.push_back(verdict_words(verdict));
    return words;
}

}  // namespace

TEST(LiveEar, GivesATakeTheVerdictOfARecording) {
    const Told& told = heard_at_once();
    ASSERT_EQ(told.takes.size(), 1u);
    EXPECT_EQ(verdicts_of_take(told.takes[0]), verdicts_of_recording(drive()));
    EXPECT_EQ(told.takes[0].why, TakeEnd::end);
}

TEST(LiveEar, TellsThePassagesOfARecordingInTime) {
    const Told& told = heard_at_once();
    for (std::size_t channel = 0; channel < 2; ++channel) {
        std::vector<std::pair<double, double>> live;
        for (const LivePassage& passage : told.passages)
            if (passage.channel == channel) live.emplace_back(passage.from, passage.to);
        std::vector<std::pair<double, double>> of_recording;
        for (const classification::HeardPassage& passage : told.takes[0].verdicts[channel].passages)
            of_recording.emplace_back(passage.from, passage.to);
        EXPECT_EQ(live, of_recording) << channel;
        EXPECT_FALSE(live.empty());
    }
}

TEST(LiveEar, HearsTheSquealAndTheCreak) {
    const auto is_told = [&](Category category, double from, double to) {
        const auto& passages = heard_at_once().passages;
        return std::any_of(passages.begin(), passages.end(), [&](const LivePassage& passage) {
            return passage.channel == 0 && passage.category() == category && passage.to > from && passage.from < to;
        });
    };
    EXPECT_TRUE(is_told(Category::squeal, 5.0, 8.0));
    EXPECT_TRUE(is_told(Category::creak, 20.0, 23.0));
}

TEST(LiveEar, GuessesWhatSoundsBeforeThePassageIsTold) {
    std::size_t noisy = 0;
    LiveListener listener;
    listener.passage = [&](const LivePassage& passage) { noisy += passage.category() == Category::none ? 0 : 1; };
    LiveEar ear(stereo(), {}, listener);
    std::size_t at = 0;
    const auto hear = [&](double until) {
        const std::size_t to = 2 * static_cast<std::size_t>(until * rate);
        ear.push(std::span(drive()).subspan(at, to - at));
        at = to;
        ear.guess();
        return ear.courses().front().guess;
    };
    EXPECT_EQ(hear(0.3).category, Category::none);  // too short for a guess
    EXPECT_EQ(hear(4.5).category, Category::none);
    const LiveGuess squeal = hear(6.5);
    EXPECT_EQ(squeal.category, Category::squeal);
    EXPECT_GT(squeal.probability, 0.5);
    EXPECT_EQ(noisy, 0U);
    EXPECT_EQ(hear(17.0).category, Category::none);  // background of the squeal
    EXPECT_EQ(hear(22.0).category, Category::creak);
    ear.gap();
    ear.guess();
    EXPECT_EQ(ear.courses().front().guess.category, Category::none);
}

// the pieces are anything from one frame to seconds
TEST(LiveEar, TellsTheSameHoweverTheSoundIsCut) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        support::CounterRandom random(seed);
        Told told;
        LiveEar ear(stereo(), {}, listener_to(told));
        for (std::span<const double> rest = drive(); !rest.empty();) {
            const auto piece = static_cast<std::size_t>(random.decades(1.0, 1e5)) * 2;
            const std::size_t taken = std::min(piece, rest.size());
            ear.push(rest.first(taken));
            rest = rest.subspan(taken);
        }
        ear.finish();
        ASSERT_EQ(told.words, heard_at_once().words) << seed;
    }
}

TEST(LiveEar, KeepsEachNoiseWithTwoSecondsBeforeIt) {
    const Told& told = heard_at_once();
    ASSERT_FALSE(told.noises.empty());
    for (std::size_t k = 0; k < told.noises.size(); ++k) {
        const LiveNoise& noise = told.noises[k];
        EXPECT_EQ(noise.number, k + 1);
        EXPECT_NEAR(noise.clip_from, std::max(0.0, noise.from - 2.0), 1.0 / rate);
        EXPECT_GE(noise.clip_to, noise.to);
        // the samples themselves, to single precision
        const auto first = static_cast<std::size_t>(std::llround(noise.clip_from * rate)) * 2;
        ASSERT_LE(first + told.clips[k].size(), drive().size());
        for (std::size_t n = 0; n < told.clips[k].size(); ++n)
            ASSERT_EQ(told.clips[k][n], static_cast<double>(static_cast<float>(drive()[first + n]))) << k << " " << n;
    }
    const auto holds = [&](double from, double to) {
        return std::any_of(told.noises.begin(), told.noises.end(),
                           [&](const LiveNoise& noise) { return noise.clip_from <= from && noise.clip_to >= to; });
    };
    EXPECT_TRUE(holds(4.0, 8.0));
    EXPECT_TRUE(holds(19.0, 23.0));
}

TEST(LiveEar, NeverBridgesAGap) {
    // the squeal is torn: each part is a recording of its own
    const std::size_t tear = 2 * static_cast<std::size_t>(6.5 * rate);
    Told told;
    LiveEar ear(stereo(), {}, listener_to(told));
    ear.push(std::span(drive()).first(tear));
    ear.gap();
    ear.gap();  // nothing came in between: no take
    ear.push(std::span(drive()).subspan(tear));
    ear.finish();
    ASSERT_EQ(told.takes.size(), 2u);
    EXPECT_EQ(told.takes[0].why, TakeEnd::gap);
    EXPECT_EQ(told.takes[0].to, 6.5);
    EXPECT_EQ(told.takes[1].from, 6.5);
    EXPECT_EQ(verdicts_of_take(told.takes[0]), verdicts_of_recording(std::span(drive()).first(tear)));
    EXPECT_EQ(verdicts_of_take(told.takes[1]), verdicts_of_recording(std::span(drive()).subspan(tear)));
    for (const LivePassage& passage : told.passages)
        EXPECT_TRUE(passage.to <= 6.5 + 1e-9 || passage.from >= 6.5 - 1e-9) << passage.from << " " << passage.to;
    for (const LiveNoise& noise : told.noises)
        EXPECT_TRUE(noise.clip_to <= 6.5 || noise.clip_from >= 6.5) << noise.clip_from << " " << noise.clip_to;
}

TEST(LiveEar, CutsWhatIsTooLongForOneTakeAndLosesNothing) {
    LiveEarOptions options;
    options.longest_take = 15.0;
    const Told told = heard(drive(), 1000, options);
    ASSERT_EQ(told.takes.size(), 3u);
    EXPECT_EQ(told.takes[0].why, TakeEnd::full);
    for (std::size_t k = 0; k + 1 < told.takes.size(); ++k)
        EXPECT_EQ(told.takes[k].to, told.takes[k + 1].from);
    EXPECT_EQ(told.takes.back().to, 34.0);
    const std::size_t second = 2 * static_cast<std::size_t>(15.0 * rate);
    EXPECT_EQ(verdicts_of_take(told.takes[1]), verdicts_of_recording(std::span(drive()).subspan(second, second)));
}

TEST(LiveEar, CutsANoiseThatDoesNotEndIntoClipsThatFollowEachOther) {
    std::vector<double> frames;
    support::CounterRandom random(9);
    for (std::size_t n = 0; n < static_cast<std::size_t>(30.0 * rate); ++n) {
        double squeal = 0.0;
        for (int k = 1; k <= 8; ++k)
            squeal += 0.1 * turn(700.0 * k * static_cast<double>(n) / rate) / k;
        frames.push_back(squeal + 1e-3 * static_cast<double>(random.next() >> 11U) * 0x1p-53);
    }
    LiveEarOptions options;
    options.longest_clip = 8.0;
    const Told told = heard(frames, 777, options, {rate, {{"", signal::full_scale}}, {}});
    ASSERT_GE(told.noises.size(), 3u);
    EXPECT_TRUE(told.noises[0].is_cut);
    for (std::size_t k = 0; k + 1 < told.noises.size(); ++k)
        EXPECT_NEAR(told.noises[k].clip_to, told.noises[k + 1].clip_from, 1.0 / rate);
}

TEST(LiveEar, HearsAMotionByTheRules) {
    const signal::ChannelLayout layout = stereo("m/s^2");
    const Told told = heard(drive(), 5000, {}, layout);
    ASSERT_EQ(told.takes.size(), 1u);
    EXPECT_EQ(verdicts_of_take(told.takes[0]), verdicts_of_recording(drive(), layout));
    EXPECT_EQ(told.words, heard(drive(), 333332, {}, layout).words);
    EXPECT_TRUE(std::any_of(told.passages.begin(), told.passages.end(), [](const LivePassage& passage) {
        return passage.category() == Category::squeal && passage.to > 5.0 && passage.from < 8.0;
    }));
}

// the mean square of a tone is half the square of its amplitude; "fast" forgets it by the factor e in 125 ms
TEST(LiveEar, ShowsTheLevelOfEachChannelSecondBySecond) {
    LiveEar ear(stereo(), {}, {});
    std::vector<double> frames;
    for (std::size_t n = 0; n < static_cast<std::size_t>(4.0 * rate); ++n) {
        const double tone =
            n < static_cast<std::size_t>(3.0 * rate) ? turn(700.0 * static_cast<double>(n) / rate) : 0.0;
        frames.push_back(tone);
        frames.push_back(0.5 * tone);
    }
    ear.push(frames);
    ear.finish();
    ASSERT_EQ(ear.courses().size(), 2U);
    for (const auto& [channel, power] : {std::pair(0, 0.5), std::pair(1, 0.125)}) {
        const LiveCourse& course = ear.courses()[static_cast<std::size_t>(channel)];
        EXPECT_NEAR(course.now, power * std::exp(-1.0 / 0.125), 1e-5 * power);
        ASSERT_GE(course.seconds.size(), 4U);
        for (std::size_t second = 0; second < 3; ++second)
            EXPECT_NEAR(course.seconds[second], power, 0.02 * power) << second;
    }
}

TEST(LiveEar, TellsHowMuchItHasHeardAlsoWithinABlock) {
    LiveEar ear(stereo(), {}, {});
    ear.push(std::vector<double>(2 * 4321, 0.1));
    EXPECT_EQ(ear.heard(), 4321.0 / rate);
}

TEST(LiveEar, RefusesWhatIsNoSampleAndKeepsWhatCameBefore) {
    std::vector<double> frames = drive();
    frames[2 * 160'000 + 1] = std::numeric_limits<double>::quiet_NaN();
    Told told;
    LiveEar ear(stereo(), {}, listener_to(told));
    EXPECT_TRUE(support::thrown_by([&] { ear.push(frames); }).says("sample 160001"));
    ear.finish();
    ASSERT_EQ(told.takes.size(), 1u);
    EXPECT_EQ(told.takes[0].to, 10.0);
}

TEST(SoundRing, HasTheLastFrames) {
    SoundRing ring(2, 5);
    std::vector<double> frames;
    for (int n = 0; n < 26; ++n)
        frames.push_back(n);
    ring.push(std::span(frames).first(6));
    ring.push(std::span(frames).subspan(6, 20));
    EXPECT_EQ(ring.begin(), 8u);
    EXPECT_EQ(ring.end(), 13u);
    const auto part = ring.part(stereo(), 9, 12);
    std::vector<double> read(100);
    ASSERT_EQ(part->read(read), 3u);
    EXPECT_EQ(std::vector<double>(read.begin(), read.begin() + 6), (std::vector<double>{18, 19, 20, 21, 22, 23}));
}

}  // namespace stridor::hearing
