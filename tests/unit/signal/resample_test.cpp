#include "stridor/signal/resample.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace stridor::signal {
namespace {

std::vector<double> tone(double rate, double frequency, std::size_t count) {
    std::vector<double> samples(count);
    for (std::size_t n = 0; n < count; ++n)
        samples[n] = base::sine_cosine_of_turns(frequency / rate * static_cast<double>(n)).sine;
    return samples;
}

// gain of the taps at a frequency that is a share of their rate: real, since they are symmetric
double gain(const std::vector<double>& taps, double frequency) {
    const std::size_t half = taps.size() / 2;
    double sum = taps[half];
    for (std::size_t k = 1; k <= half; ++k)
        sum += 2.0 * taps[half + k] * base::sine_cosine_of_turns(frequency * static_cast<double>(k)).cosine;
    return sum;
}

std::vector<double> at_rate(const std::vector<double>& samples, double from, double to) {
    return resampled({from, full_scale, samples}, to).samples;
}

// largest difference away from the ends, where the signal is cut off
double distance(const std::vector<double>& a, const std::vector<double>& b, std::size_t edge) {
    double most = 0.0;
    for (std::size_t n = edge; n + edge < std::min(a.size(), b.size()); ++n)
        most = std::max(most, std::abs(a[n] - b[n]));
    return most;
}

TEST(LowPass, KeepsItsPassBandAndEmptiesItsStopBand) {
    for (const LowPass design : {LowPass{0.2, 0.25, 110.0}, LowPass{0.05, 0.06, 80.0}, LowPass{0.01, 0.4, 140.0}}) {
        const std::vector<double> taps = low_pass_taps(design);
        // Kaiser's formula meets its attenuation within three decibels, in the pass band alike
        const double residue = std::pow(10.0, -(design.attenuation - 3.0) / 20.0);
        EXPECT_EQ(taps.size() % 2, 1U);
        EXPECT_NEAR(std::accumulate(taps.begin(), taps.end(), 0.0), 1.0, 1e-14);
        for (int k = 0; k <= 400; ++k) {
            EXPECT_NEAR(gain(taps, design.pass * k / 400.0), 1.0, residue);
            EXPECT_NEAR(gain(taps, design.stop + (0.5 - design.stop) * k / 400.0), 0.0, residue);
        }
        for (std::size_t k = 0; k < taps.size(); ++k)
            EXPECT_EQ(taps[k], taps[taps.size() - 1 - k]);
    }
}

TEST(RateRatio, IsExactBetweenTheRatesOfAudio) {
    const auto expect = [](double from, double to, int up, int down) {
        const RateRatio ratio = rate_ratio(from, to);
        EXPECT_EQ(ratio.up, up) << from << " to " << to;
        EXPECT_EQ(ratio.down, down) << from << " to " << to;
    };
    expect(48000, 48000, 1, 1);
    expect(44100, 48000, 160, 147);
    expect(51200, 44100, 441, 512);
    expect(768000, 48000, 1, 16);
    expect(8000, 48000, 6, 1);
    expect(1e6, 48000, 6, 125);
    expect(25600.0 / 3.0, 51200, 6, 1);
    const RateRatio near = rate_ratio(48000.0, 48000.0 * std::numbers::pi);
    EXPECT_NEAR(static_cast<double>(near.up) / near.down, std::numbers::pi, 5e-7 * std::numbers::pi);
}

TEST(RateRatio, RefusesWhatIsNoRate) {
    for (const double rate : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW(rate_ratio(rate, 48000.0), Error);
        EXPECT_THROW(rate_ratio(48000.0, rate), Error);
    }
    EXPECT_THROW(rate_ratio(1e9, 1.0), Error);
}

TEST(Resample, KeepsATonesPhaseAndLevel) {
    for (const auto& [from, to] :
         {std::pair{44100.0, 48000.0}, {48000.0, 44100.0}, {51200.0, 8000.0}, {8000.0, 51200.0}})
        for (const double share : {0.001, 0.1, 0.44}) {
            const double frequency = share * std::min(from, to);
            const auto count = static_cast<std::size_t>(0.2 * from);
            const std::vector<double> made = at_rate(tone(from, frequency, count), from, to);
            const std::vector<double> wanted = tone(to, frequency, made.size());
            EXPECT_EQ(made.size(), static_cast<std::size_t>(std::ceil(static_cast<double>(count) * to / from - 1e-9)));
            // ripple of the low pass, 109 dB, in the band and in each of its images
            EXPECT_LT(distance(made, wanted, made.size() / 4), 1e-5) << from << " to " << to << " at " << frequency;
        }
}

TEST(Resample, LeavesNothingOfATonesAboveTheNewBand) {
    const std::vector<double> made = at_rate(tone(48000.0, 4100.0, 9600), 48000.0, 8000.0);
    const std::vector<double> nothing(made.size(), 0.0);
    EXPECT_LT(distance(made, nothing, made.size() / 4), 5e-6);
}

TEST(Resample, IsTheSameHoweverTheInputIsCut) {
    support::CounterRandom random(7);
    std::vector<double> noise(20000);
    for (double& sample : noise)
        sample = random.between(-1.0, 1.0);
    for (const RateRatio ratio : {RateRatio{160, 147}, RateRatio{1, 16}, RateRatio{3, 1}, RateRatio{1, 1}}) {
        Resampler whole(ratio);
        std::vector<double> at_once = whole.push(noise);
        const std::vector<double> rest = whole.finish();
        at_once.insert(at_once.end(), rest.begin(), rest.end());
        EXPECT_EQ(at_once.size(),
                  (noise.size() * static_cast<std::size_t>(ratio.up) + static_cast<std::size_t>(ratio.down) - 1) /
                      static_cast<std::size_t>(ratio.down));

        Resampler cut(ratio);
        std::vector<double> in_parts;
        const auto append = [&](const std::vector<double>& part) {
            in_parts.insert(in_parts.end(), part.begin(), part.end());
        };
        for (std::size_t begin = 0; begin < noise.size();) {
            const std::size_t count = std::min(noise.size() - begin, random.below(700));
            append(cut.push(std::span(noise).subspan(begin, count)));
            begin += count;
        }
        append(cut.finish());
        EXPECT_EQ(at_once, in_parts);
    }
}

TEST(Resample, ReadsASourceInBlocksAsItDoesTheWhole) {
    support::CounterRandom random(11);
    std::vector<Signal> channels(2, Signal{44100.0, "Pa", std::vector<double>(50000)});
    for (Signal& channel : channels)
        for (double& sample : channel.samples)
            sample = random.between(-1.0, 1.0);
    const std::unique_ptr<Source> source = resampled(source_of(channels), 48000.0);
    EXPECT_EQ(source->layout().rate, 48000.0);
    const std::vector<Signal> made = read_all(*source);
    ASSERT_EQ(made.size(), 2U);
    EXPECT_EQ(source->layout().frames, made[0].samples.size());
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(made[k].samples, resampled(channels[k], 48000.0).samples);
        EXPECT_EQ(made[k].unit, "Pa");
    }
    EXPECT_EQ(read_all(*resampled(source_of({{44100.0, "Pa", {}}}), 48000.0)).front().samples.size(), 0U);
}

}  // namespace
}  // namespace stridor::signal
