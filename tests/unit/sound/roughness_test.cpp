// Roughness is that of Daniel and Weber (1997): of their reference, of their listeners, of noise and of steady tones.

#include "stridor/sound/roughness.hpp"

#include "stridor/sound/roughness_tables.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace stridor::sound {
namespace {

using Pressures = std::vector<double>;

constexpr double sampling_rate = 48000.0;

// brings a sound to a level [dB]
Pressures at_level(Pressures samples, double level) {
    double power = 0.0;
    for (double x : samples)
        power += x * x;
    const double scale = 2e-5 * std::pow(10.0, level / 20.0) / std::sqrt(power / static_cast<double>(samples.size()));
    for (double& x : samples)
        x *= scale;
    return samples;
}

// a tone whose amplitude goes with 1 + depth sin
Pressures modulated_tone(double carrier, double modulation, double level = 60.0, double depth = 1.0,
                         double duration = 0.8) {
    Pressures samples(static_cast<std::size_t>(duration * sampling_rate));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(n) / sampling_rate;
        samples[n] = (1.0 + depth * std::sin(modulation * turn)) * std::sin(carrier * turn);
    }
    return at_level(std::move(samples), level);
}

Pressures noise(double level, double modulation) {
    support::CounterRandom random(1);
    Pressures samples(static_cast<std::size_t>(2.0 * sampling_rate));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(n) / sampling_rate;
        samples[n] = random.between(-1.0, 1.0) * (modulation > 0.0 ? 1.0 + std::sin(modulation * turn) : 1.0);
    }
    return at_level(std::move(samples), level);
}

double roughness_of(std::span<const double> pressures) {
    RoughnessMeter meter;
    meter.push(pressures);
    return meter.mean();
}

TEST(Roughness, IsOneAsperOfTheReference) {
    EXPECT_NEAR(roughness_of(modulated_tone(1000.0, 70.0, 60.0, 1.0, 2.0)), 1.0, 1e-4);
}

// An implementation of the model in another language (NumPy, complex transforms, time signals transformed back).
TEST(Roughness, EqualsAnotherImplementation) {
    EXPECT_NEAR(roughness_of(modulated_tone(1000.0, 70.0, 60.0, 1.0, 0.9)), 0.9999982548512544, 1e-11);
    EXPECT_NEAR(roughness_of(modulated_tone(250.0, 50.0, 60.0, 1.0, 0.9)), 0.4432778678960641, 1e-11);
    EXPECT_NEAR(roughness_of(modulated_tone(2000.0, 160.0, 60.0, 1.0, 0.9)), 0.3579380327618004, 1e-11);
    EXPECT_NEAR(roughness_of(modulated_tone(125.0, 30.0, 60.0, 1.0, 0.9)), 0.3127257540152746, 1e-11);
    EXPECT_NEAR(roughness_of(modulated_tone(8000.0, 100.0, 60.0, 1.0, 0.9)), 0.3190147960614671, 1e-11);
}

// Daniel and Weber, figure 3: what listeners found of tones of 60 dB, wholly modulated; read from the figure.
struct Heard {
    double carrier;              // [Hz]
    std::vector<double> values;  // [asper] of 20, 40, ... Hz
};

const std::array heard{
    Heard{125.0, {0.27, 0.33, 0.19, 0.09, 0.04}},
    Heard{250.0, {0.27, 0.47, 0.37, 0.21, 0.11, 0.06}},
    Heard{500.0, {0.22, 0.62, 0.68, 0.52, 0.34, 0.21, 0.12, 0.07}},
    Heard{1000.0, {0.20, 0.64, 0.96, 0.91, 0.70, 0.49, 0.35, 0.25}},
    Heard{2000.0, {0.21, 0.54, 0.80, 0.79, 0.67, 0.52, 0.38, 0.27}},
    Heard{4000.0, {0.17, 0.43, 0.63, 0.63, 0.50, 0.38, 0.29, 0.24}},
    Heard{8000.0, {0.12, 0.29, 0.44, 0.45, 0.34, 0.26, 0.20, 0.16}},
};

TEST(Roughness, IsWhatListenersFound) {
    std::vector<double> deviations;
    for (const Heard& row : heard) {
        double squares = 0.0;
        for (std::size_t k = 0; k < row.values.size(); ++k) {
            const double modulation = 20.0 * static_cast<double>(k + 1);
            const double difference = roughness_of(modulated_tone(row.carrier, modulation)) - row.values[k];
            squares += difference * difference;
            if (row.values[k] > 0.1) deviations.push_back(std::abs(difference) / row.values[k]);
        }
        const double rms = std::sqrt(squares / static_cast<double>(row.values.size()));
        RecordProperty("rms_" + std::to_string(static_cast<int>(row.carrier)) + "_Hz", std::to_string(rms));
        EXPECT_LT(rms, row.carrier == 2000.0 ? 0.11 : 0.07) << row.carrier;
    }
    std::sort(deviations.begin(), deviations.end());
    const double median = deviations[deviations.size() / 2];
    RecordProperty("median_deviation", std::to_string(median));
    EXPECT_LT(median, 0.13);
    // the least difference one notices is 17 % (Fastl and Zwicker, 2007)
    const auto noticed = std::count_if(deviations.begin(), deviations.end(), [](double x) { return x > 0.17; });
    RecordProperty("noticed", std::to_string(noticed) + " of " + std::to_string(deviations.size()));
    EXPECT_LT(static_cast<double>(noticed), 0.35 * static_cast<double>(deviations.size()));
}

// Fastl and Zwicker (2007), 11.1: it goes with the 1.6th power of the depth
TEST(Roughness, GrowsWithTheDepthOfTheModulation) {
    double last = 1.0;
    for (double depth : {0.8, 0.6, 0.4, 0.2}) {
        const double value = roughness_of(modulated_tone(1000.0, 70.0, 60.0, depth));
        EXPECT_NEAR(value, std::pow(depth, 1.6), 0.06) << depth;
        EXPECT_LT(value, last);
        last = value;
    }
}

// Daniel and Weber: some 0.02 asper of 70 dB, below the least one hears (0.07); some 3 asper of modulated noise
TEST(Roughness, TellsNoiseFromModulatedNoise) {
    EXPECT_LT(roughness_of(noise(70.0, 0.0)), 0.07);
    EXPECT_GT(roughness_of(noise(70.0, 70.0)), 2.0);
}

TEST(Roughness, IsNoneOfASteadyToneAndOfSilence) {
    EXPECT_LT(roughness_of(modulated_tone(1000.0, 1.0, 60.0, 0.0)), 1e-3);
    EXPECT_EQ(roughness_of(Pressures(48000)), 0.0);
    EXPECT_EQ(roughness_of(modulated_tone(1000.0, 70.0, -20.0)), 0.0);  // below the threshold of hearing
}

TEST(Roughness, OfWhatIsBeyondAllNumbersIsNone) {
    EXPECT_EQ(roughness_of(Pressures(9600, std::numeric_limits<double>::infinity())), 0.0);
}

TEST(Roughness, OfAShortSoundIsNone) {
    RoughnessMeter meter;
    meter.push(Pressures(9599, 0.1));
    EXPECT_TRUE(std::isnan(meter.mean()));
    EXPECT_TRUE(std::isnan(meter.exceeded(0.05)));
    meter.push(Pressures(1, 0.1));
    EXPECT_FALSE(std::isnan(meter.mean()));
}

TEST(Roughness, HasTheSameBitsInAnyPiecesAndUpsideDown) {
    Pressures sound = modulated_tone(700.0, 45.0);
    const double whole = roughness_of(sound);
    RoughnessMeter meter;
    for (std::size_t from = 0, size = 1; from < sound.size(); from += size, size = size * 3 % 7919 + 1)
        meter.push(std::span(sound).subspan(from, std::min(size, sound.size() - from)));
    EXPECT_EQ(meter.mean(), whole);
    for (double& x : sound)
        x = -x;
    EXPECT_EQ(roughness_of(sound), whole);
}

TEST(Roughness, OfATimeIsExceededInItsShare) {
    Pressures sound = modulated_tone(1000.0, 70.0, 60.0, 1.0, 1.0);
    const Pressures steady = modulated_tone(1000.0, 1.0, 60.0, 0.0, 9.0);
    sound.insert(sound.end(), steady.begin(), steady.end());
    RoughnessMeter meter;
    meter.push(sound);
    EXPECT_NEAR(meter.exceeded(0.05), 1.0, 0.02);
    EXPECT_LT(meter.exceeded(0.5), 0.01);
    EXPECT_NEAR(meter.mean(), 0.1, 0.02);
}

TEST(RoughnessTables, HoldTheirPointsAndGoStraightBetweenThem) {
    EXPECT_EQ(critical_band_rate(1000.0), 8.5);
    EXPECT_EQ(critical_band_rate(1035.0), 8.71875);
    EXPECT_EQ(critical_band_rate(30000.0), 24.5);
    EXPECT_EQ(transmission(8.5), 0.0);
    EXPECT_EQ(transmission(16.5), 7.38);
    EXPECT_EQ(hearing_threshold(16.0), -4.0);
    EXPECT_DOUBLE_EQ(modulation_weight(8.5), 0.94);
    EXPECT_DOUBLE_EQ(modulation_weight(24.0), 0.3);
    EXPECT_EQ(modulation_response(16, 79.0), 1.0);
    for (std::size_t channel = 0; channel < 47; ++channel) {
        EXPECT_EQ(modulation_response(channel, 0.0), 0.0);
        EXPECT_EQ(modulation_response(channel, 650.0), 0.0);
    }
}

}  // namespace
}  // namespace stridor::sound
