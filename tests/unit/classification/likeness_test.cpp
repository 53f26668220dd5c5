#include "stridor/classification/likeness.hpp"

#include "stridor/classification/compared_sound.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/sound/analysis.hpp"
#include "support/property.hpp"

#include <cmath>
#include <numbers>

namespace stridor::classification {
namespace {

using signal::Signal;
using support::number_between;

// a tone with harmonics, or with `rest` > 0 impulses of it
Signal tone(double frequency, double rest = 0.0) {
    Signal signal{16000.0, "Pa", {}};
    for (int k = 0; k < 16000; ++k) {
        const double time = k / signal.rate;
        const double turns = frequency * time;
        const bool is_at_rest = std::fmod(time, 0.02) < 0.02 * rest;
        const double wave = std::sin(2.0 * std::numbers::pi * turns) + 0.3 * std::sin(4.0 * std::numbers::pi * turns);
        signal.samples.push_back(is_at_rest ? 0.0 : wave);
    }
    return signal;
}

SoundProfile profile(const Signal& signal) {
    const auto source = signal::source_of({signal});
    const sound::SoundAnalysis analysis = sound::analyse(*source).front();
    const parameters::SoundThresholds thresholds;
    return profile_of(analysis.stretches, classify_recording(analysis.stretches, thresholds), thresholds);
}

// any figures, not only those that a sound could have
rc::Gen<SoundProfile> any_profile() {
    return rc::gen::map(rc::gen::container<std::vector<double>>(10, number_between(0.0, 1.0)),
                        [](const std::vector<double>& x) {
                            SoundProfile p;
                            p.features.mean_square = 1.0 + x[0];
                            p.features.frequency = 4000.0 * x[1];
                            p.features.repetition_frequency = 4000.0 * x[2];
                            p.features.tonality = x[3];
                            p.features.repetition = x[4];
                            p.features.unsteadiness = 10.0 * x[5];
                            p.features.rest = x[6];
                            p.features.kurtosis = 1.0 + 100.0 * x[7];
                            p.impulse_interval = 0.1 * x[8];
                            p.impulse_regularity = x[9];
                            return p;
                        });
}

}  // namespace

RC_GTEST_PROP(Likeness, IsZeroForASoundAndItself, ()) {
    const SoundProfile p = *any_profile();
    const Likeness same = likeness(p, p, LevelUse::counted);
    RC_ASSERT(same.distance == 0.0);
    for (const FigureDifference& each : same.differences)
        RC_ASSERT(each.share == 0.0);
}

RC_GTEST_PROP(Likeness, IsSymmetricAndBounded, ()) {
    const SoundProfile a = *any_profile();
    const SoundProfile b = *any_profile();
    const Likeness there = likeness(a, b, LevelUse::counted);
    RC_ASSERT(std::abs(there.distance - likeness(b, a, LevelUse::counted).distance) <= 1e-12);
    RC_ASSERT(there.distance >= 0.0 && there.distance <= most_steps);
    double shares = 0.0;
    for (const FigureDifference& each : there.differences)
        shares += each.share;
    RC_ASSERT(there.distance == 0.0 || std::abs(shares - 1.0) <= 1e-12);
}

TEST(Likeness, IgnoresGainUnlessTheLevelCounts) {
    const SoundProfile p = profile(tone(440.0));
    const SoundProfile louder = profile(signal::amplified(tone(440.0), 20.0));
    // a gain of 20 dB is a factor of 10 but for rounding
    EXPECT_LT(likeness(p, louder).distance, 1e-6);
    EXPECT_GT(likeness(p, louder, LevelUse::counted).distance, 0.5);
}

TEST(Likeness, GrowsWithTheIntervalBetweenTones) {
    const SoundProfile p = profile(tone(440.0));
    double before = 0.0;
    for (const double frequency : {450.0, 466.0, 494.0, 523.0}) {
        const double now = likeness(p, profile(tone(frequency))).distance;
        EXPECT_GT(now, before) << frequency;
        before = now;
    }
}

TEST(Likeness, FindsTheSameSoundAgainThroughNoise) {
    const SoundProfile p = profile(tone(440.0));
    const SoundProfile noisy = profile(signal::with_noise(tone(440.0), 20.0, 7));
    EXPECT_LT(likeness(p, noisy).distance, likeness(p, profile(tone(470.0))).distance);
    EXPECT_LT(likeness(p, noisy).distance, 0.3);
}

TEST(Likeness, NamesTheOneFigureThatDiffersHoweverLittle) {
    for (const double difference : {1e-3, 0.1, 0.5}) {
        SoundProfile p = profile(tone(440.0));
        SoundProfile q = p;
        q.features.rest += difference;
        const Likeness apart = likeness(p, q);
        EXPECT_GT(apart.distance, 0.0);
        EXPECT_EQ(apart.differences.front().name, "rest") << difference;
        EXPECT_NEAR(apart.differences.front().share, 1.0, 1e-12) << difference;
    }
}

TEST(Likeness, NamesWhatTellsImpulsesFromATone) {
    const Likeness apart = likeness(profile(tone(440.0)), profile(tone(440.0, 0.8)));
    EXPECT_GT(apart.distance, 1.0);
    for (const FigureDifference& each : apart.differences)
        if (each.name == "frequency") {
            EXPECT_LT(each.share, 0.2) << "both have the same tone";
        }
}

TEST(Likeness, SilenceIsFarFromEverySoundAndAlikeAmongItself) {
    const SoundProfile silence = profile({16000.0, "Pa", std::vector<double>(16000, 0.0)});
    EXPECT_TRUE(is_silent(silence));
    EXPECT_EQ(likeness(silence, silence).distance, 0.0);
    EXPECT_EQ(likeness(silence, profile(tone(440.0))).distance, most_steps);
}

TEST(Profile, IsMadeOfTheLoudParts) {
    Signal signal = tone(440.0);
    const Signal other = signal::amplified(tone(1000.0), -40.0);
    signal.samples.insert(signal.samples.end(), other.samples.begin(), other.samples.end());
    const SoundProfile p = profile(signal);
    EXPECT_NEAR(p.features.frequency, 440.0, 2.0);
    EXPECT_NEAR(p.features.duration, 1.0, 0.1);
}

TEST(Profile, LeavesOutWhatIsQuieterThanTheThreshold) {
    const parameters::SoundThresholds thresholds;
    for (const double beyond : {-1.0, 1.0}) {
        std::vector<sound::SoundStretch> stretches(2);
        stretches[0].features.duration = stretches[1].features.duration = 1.0;
        stretches[0].features.mean_square = 1.0;
        stretches[1].features.mean_square = std::pow(10.0, -0.1 * (thresholds.quiet_depth + beyond));
        const SoundProfile p = profile_of(stretches, {}, thresholds);
        EXPECT_EQ(p.features.duration, beyond < 0.0 ? 2.0 : 1.0) << beyond << " dB below it";
    }
}

// a stretch is too short to show the period of slow impulses: the instants of all of them do
TEST(Profile, TakesSlowImpulsesFromTheLoudestSegmentOfItsCategory) {
    const parameters::SoundThresholds thresholds;
    std::vector<sound::SoundStretch> stretches(1);
    stretches[0].features.duration = 1.0;
    stretches[0].features.mean_square = 1.0;
    stretches[0].features.impulse_interval = 0.01;
    stretches[0].features.impulse_periodicity = 0.5 * thresholds.creak_periodicity;
    RecordingVerdict verdict;
    verdict.category = Category::creak;
    const auto segment = [](Category category, double mean_square, double interval) {
        SoundSegment result;
        result.verdict.category = category;
        result.mean_square = mean_square;
        result.impulse_interval = interval;
        result.impulse_regularity = 0.9;
        return result;
    };
    EXPECT_EQ(profile_of(stretches, verdict, thresholds).impulse_interval, 0.01) << "no segment is a creak";
    verdict.segments = {segment(Category::creak, 1.0, 0.2), segment(Category::creak, 2.0, 0.3),
                        segment(Category::creak, 1.5, 0.4), segment(Category::squeal, 9.0, 0.5)};
    EXPECT_EQ(profile_of(stretches, verdict, thresholds).impulse_interval, 0.3);
    EXPECT_EQ(profile_of(stretches, verdict, thresholds).impulse_regularity, 0.9);
    stretches[0].features.impulse_periodicity = thresholds.creak_periodicity;
    EXPECT_EQ(profile_of(stretches, verdict, thresholds).impulse_interval, 0.01) << "the stretch shows it itself";
}

TEST(ComparedFigures, AreUnknownInSilence) {
    ComparedSound sound;
    for (const ComparedFigure& figure : compared_figures()) {
        EXPECT_TRUE(std::isnan(figure.value(sound))) << figure.name;
        EXPECT_EQ(figure_text(figure, sound), "-");
    }
    sound.profile = profile(tone(440.0));
    sound.analysis.unit = "Pa";
    for (const ComparedFigure& figure : compared_figures())
        if (figure.name == "frequency") {
            EXPECT_EQ(figure_text(figure, sound), "440 Hz");
        }
}

}  // namespace stridor::classification
