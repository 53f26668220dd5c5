#include "stridor/classification/recording_verdict.hpp"

#include "stridor/classification/ear_weights.hpp"
#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stridor::classification {
namespace {

sound::SoundAnalysis analysed(std::vector<signal::Signal> parts, const char* unit = signal::full_scale) {
    signal::Signal whole = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k)
        whole.samples.insert(whole.samples.end(), parts[k].samples.begin(), parts[k].samples.end());
    whole.unit = unit;
    return sound::analyse(*signal::source_of({whole})).front();
}

signal::Signal softer(signal::Signal signal, double factor) {
    for (double& sample : signal.samples)
        sample *= factor;
    return signal;
}

double share(const RecordingVerdict& verdict, Category category) {
    return verdict.shares[static_cast<std::size_t>(category)];
}

TEST(RecordingVerdict, OfAMotionIsThatOfTheRules) {
    const sound::SoundAnalysis motion = analysed({support::squeal(1.0)}, "m/s");
    EXPECT_TRUE(motion.passages.empty());
    const RecordingVerdict verdict = verdict_on(motion, {});
    EXPECT_TRUE(verdict.passages.empty());
    EXPECT_EQ(verdict.probability, 0.0);
    EXPECT_FALSE(verdict.segments.front().verdict.margins.empty());
}

// a few samples of an impulse, and nothing above half the rate: white noise of any rate is no creak there
TEST(RecordingVerdict, OfANarrowBandIsASquealOrUndecided) {
    for (const double rate : {1000.0, 2000.0, 4000.0, 7999.0, 8000.0, 16000.0})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            signal::Signal silence{rate, "m/s^2", std::vector<double>(static_cast<std::size_t>(2.0 * rate))};
            silence.samples.front() = 1e-9;
            const sound::SoundAnalysis noise = analysed({signal::with_noise(silence, -100.0, seed)}, "m/s^2");
            const RecordingVerdict verdict = verdict_on(noise, {});
            EXPECT_EQ(verdict.category, rate < 8000.0 ? Category::undecided : Category::none)
                << rate << " Hz, " << seed << ": " << verdict.reasons.front();
        }
    const auto at_4_khz = [](double value(double)) {
        signal::Signal signal{4000.0, "m/s", {}};
        for (std::size_t n = 0; n < 4000; ++n)
            signal.samples.push_back(value(static_cast<double>(n) / 4000.0));
        return verdict_on(analysed({signal}, "m/s"), {});
    };
    EXPECT_EQ(at_4_khz([](double t) { return support::sine(700.0 * t); }).category, Category::squeal);
    const RecordingVerdict impulses = at_4_khz([](double t) {
        const double since = std::fmod(t, 0.05);
        return std::exp(-since / 0.003) * support::sine(700.0 * since);
    });
    EXPECT_EQ(impulses.category, Category::undecided);
    EXPECT_NE(impulses.reasons.back().find("creak is a guess: 4000 samples a second"), std::string::npos)
        << impulses.reasons.back();
}

TEST(RecordingVerdict, NamesTheNoiseAndNotTheMajority) {
    const RecordingVerdict verdict = verdict_on(
        analysed({softer(support::hiss(3.0), 0.5), softer(support::squeal(3.0), 0.3), softer(support::hiss(3.0), 0.5)}),
        {});
    EXPECT_EQ(verdict.category, Category::squeal);
    EXPECT_LT(share(verdict, Category::squeal), 0.9);
    EXPECT_NE(verdict.reasons.front().find("over rubbing"), std::string::npos) << verdict.reasons.front();
    EXPECT_GT(verdict.probability, 0.5);
    // the squeal is the middle segment
    ASSERT_EQ(verdict.segments.size(), 3U);
    EXPECT_EQ(verdict.segments[1].verdict.category, Category::squeal);
    EXPECT_NEAR(verdict.segments[1].from, 3.0, 0.1);
    EXPECT_NEAR(verdict.segments[1].to, 6.0, 0.1);
}

TEST(RecordingVerdict, TellsASecondNoise) {
    parameters::SoundThresholds thresholds;
    thresholds.least_share = 0.02;
    const RecordingVerdict verdict =
        verdict_on(analysed({softer(support::squeal(3.0), 0.3), support::creak()}), thresholds);
    ASSERT_EQ(verdict.reasons.size(), 2U);
    EXPECT_NE(verdict.reasons[1].find(" too, "), std::string::npos) << verdict.reasons[1];
    EXPECT_GT(share(verdict, Category::squeal), 0.0);
    EXPECT_GT(share(verdict, Category::creak), 0.0);
}

TEST(RecordingVerdict, CountsTheOnsetsOfACreak) {
    const RecordingVerdict verdict = verdict_on(analysed({support::creak()}), {});
    ASSERT_EQ(verdict.category, Category::creak);
    const SoundSegment* loudest = verdict.loudest();
    ASSERT_NE(loudest, nullptr);
    EXPECT_GT(loudest->impulses.size(), 20U);
    EXPECT_GT(loudest->impulse_interval, 0.04);
    EXPECT_LT(loudest->impulse_interval, 0.13);
    EXPECT_GT(loudest->impulse_regularity, 0.9);
}

TEST(RecordingVerdict, AbstainsBelowTheCertaintyAskedFor) {
    parameters::SoundThresholds thresholds;
    thresholds.certainty = 1.0;
    const RecordingVerdict verdict = verdict_on(analysed({support::creak()}), thresholds);
    EXPECT_EQ(verdict.category, Category::undecided);
    EXPECT_NE(verdict.reasons.back().find("not likely enough"), std::string::npos);
}

// clicks that nothing rings after, so many a second
signal::Signal clicks(double rate) {
    signal::Signal sound = softer(support::hiss(3.0), 0.003);
    for (double t = 0.1; t < 2.9; t += 1.0 / rate)
        sound.samples[static_cast<std::size_t>(t * sound.rate)] += 0.5;
    return sound;
}

// a row without ringing is heard as quiet, and with the certainty that such verdicts have
TEST(RecordingVerdict, IsNotSureOfQuietWhereARowStandsInTheSound) {
    std::size_t quiet = 0;
    for (const double rate : {12.0, 20.0, 30.0, 45.0}) {
        const RecordingVerdict verdict = verdict_on(analysed({clicks(rate)}), {});
        if (verdict.category != Category::none) continue;
        ++quiet;
        EXPECT_LE(verdict.probability, ear_row.right) << rate;
        EXPECT_NE(verdict.reasons.front().find("though a row of onsets stands in it, train "), std::string::npos)
            << rate << ": " << verdict.reasons.front();
    }
    EXPECT_GT(quiet, 0U);
    const RecordingVerdict hiss = verdict_on(analysed({support::hiss(3.0)}), {});
    EXPECT_EQ(hiss.category, Category::none);
    EXPECT_GT(hiss.probability, ear_row.right);
    EXPECT_EQ(hiss.reasons.front().find("though"), std::string::npos) << hiss.reasons.front();
    // what is far below the rest argues for nothing
    const RecordingVerdict over = verdict_on(
        analysed({support::hiss(3.0), softer(support::hiss(1.0), 0.0), softer(support::squeal(3.0), 1e-3)}), {});
    EXPECT_EQ(over.category, Category::none);
    EXPECT_EQ(over.reasons.front().find("though"), std::string::npos) << over.reasons.front();
}

// both channels alike, one of them 1.4 dB softer or silent, or mixed to one: the recording is what its sound is
TEST(RecordingVerdict, IsTheSameInStereoAndInMono) {
    for (const signal::Signal& sound : {support::creak(), support::squeal(2.0), support::hiss(2.0)}) {
        const RecordingVerdict usual = verdict_on(analysed({sound}), {});
        const double soft = std::pow(10.0, -0.05 * 1.4);
        for (const double factor : {1.0, soft, 0.0}) {
            const signal::Signal other = softer(sound, factor);
            for (const auto& stereo : {std::vector{sound, other}, std::vector{other, sound}}) {
                const std::vector<sound::SoundAnalysis> channels = sound::analyse(*signal::source_of(stereo));
                const RecordingVerdict heard = verdict_on(channels[sound::loudest(channels)], {});
                EXPECT_EQ(heard.category, usual.category) << factor;
                EXPECT_EQ(heard.probability, usual.probability) << factor;
                // the softer one says so, too, and silence says nothing
                const std::size_t softest = 1 - sound::loudest(channels);
                EXPECT_EQ(verdict_on(channels[softest], {}).category, factor > 0.0 ? usual.category : Category::none);
            }
            signal::Signal mixed = sound;
            for (std::size_t n = 0; n < mixed.samples.size(); ++n)
                mixed.samples[n] = 0.5 * (sound.samples[n] + other.samples[n]);
            EXPECT_EQ(verdict_on(analysed({mixed}), {}).category, usual.category) << factor;
        }
    }
}

TEST(RecordingVerdict, TakesWhatIsFarBelowForBackground) {
    const RecordingVerdict verdict = verdict_on(
        analysed({support::squeal(3.0), softer(support::creak(), 1e-4), softer(support::creak(), 1e-4)}), {});
    EXPECT_EQ(verdict.category, Category::squeal);
    ASSERT_GT(verdict.passages.size(), 1U);
    EXPECT_EQ(verdict.passages.back().category, Category::none);
}

// an accelerometer on its side: 9.81 m/s^2 and noise of 0.01 m/s^2
TEST(RecordingVerdict, DoesNotHearTheGravityThatARecordingBeginsWith) {
    signal::Signal still = softer(support::hiss(2.0), 0.1);
    for (double& sample : still.samples)
        sample += 9.81;
    const sound::SoundAnalysis analysis = analysed({still}, "m/s^2");
    EXPECT_NEAR(signal::level_of(analysis.mean_square, 1e-6), 80.0, 0.1);
    EXPECT_NEAR(analysis.level.greatest, 80.0, 1.0);
    EXPECT_LT(analysis.peak, 0.1);
    EXPECT_EQ(verdict_on(analysis, {}).category, Category::none);
}

TEST(RecordingVerdict, IsOfTheChannelThatIsLoudestAboveTheDrive) {
    signal::Signal tone = softer(support::squeal(2.0), 0.1);
    signal::Signal swing = tone;
    for (std::size_t k = 0; k < swing.samples.size(); ++k)
        swing.samples[k] = 9.81 + 3.0 * support::sine(2.0 * static_cast<double>(k) / swing.rate);
    tone.unit = swing.unit = "m/s^2";
    const std::vector<sound::SoundAnalysis> channels = sound::analyse(*signal::source_of({swing, tone}));
    EXPECT_EQ(sound::loudest(channels), 1U);
    EXPECT_EQ(verdict_on(channels[1], {}).category, Category::squeal);
}

signal::Signal cut(signal::Signal signal, double seconds) {
    signal.samples.erase(signal.samples.begin(),
                         signal.samples.begin() + static_cast<std::ptrdiff_t>(seconds * signal.rate));
    return signal;
}

// the noise of a room or silence in front, behind and between, the sound twice, begun later or softer: it is the same
TEST(RecordingVerdict, IsOfTheSoundAndNotOfThePause) {
    for (const signal::Signal& sound : {support::creak(), support::squeal(2.0), support::hiss(2.0)}) {
        const Category usual = verdict_on(analysed({sound}), {}).category;
        for (const double pause : {0.2, 0.7, 2.0, 5.0})
            for (const double factor : {0.0, 0.004}) {
                const signal::Signal room = softer(support::hiss(pause), factor);
                for (const auto& parts : {std::vector{room, sound}, std::vector{sound, room},
                                          std::vector{sound, room, sound}, std::vector{room, sound, room}})
                    EXPECT_EQ(verdict_on(analysed(parts), {}).category, usual) << pause << " s, " << factor;
            }
        EXPECT_EQ(verdict_on(analysed({sound, sound}), {}).category, usual);
        EXPECT_EQ(verdict_on(analysed({cut(sound, 0.2)}), {}).category, usual);
        EXPECT_EQ(verdict_on(analysed({softer(sound, 0.01)}), {}).category, usual);
    }
}

TEST(RecordingVerdict, OfSilenceIsNone) {
    const RecordingVerdict verdict = verdict_on(analysed({support::sampled(1.0, [](double) { return 0.0; })}), {});
    EXPECT_EQ(verdict.category, Category::none);
    EXPECT_EQ(verdict.reasons.front(), "there is nothing to hear");
    for (const SoundSegment& segment : verdict.segments)
        EXPECT_TRUE(segment.verdict.reasons.empty());
}

}  // namespace
}  // namespace stridor::classification
