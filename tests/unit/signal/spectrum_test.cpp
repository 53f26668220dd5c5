#include "stridor/signal/spectrum.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/signal/filter.hpp"
#include "stridor/signal/level.hpp"
#include "stridor/signal/median.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/signal/powers.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/signal/spectrogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace stridor::signal {
namespace {

Signal tone(double frequency, double amplitude, double duration, double rate = 48000.0) {
    Signal result{rate, "Pa", {}};
    const auto count = static_cast<std::size_t>(duration * rate);
    for (std::size_t n = 0; n < count; ++n)
        result.samples.push_back(amplitude *
                                 base::sine_cosine_of_turns(frequency * static_cast<double>(n) / rate).sine);
    return result;
}

Signal noise(double deviation, double duration, double rate = 48000.0) {
    Signal one{rate, "Pa", std::vector<double>(static_cast<std::size_t>(duration * rate))};
    one.samples[0] = 1.0;  // so that there is a power to be relative to
    const double square =
        (1.0 - 1.0 / static_cast<double>(one.samples.size())) / static_cast<double>(one.samples.size());
    Signal result = with_noise(one, -20.0 * std::log10(deviation / std::sqrt(square)), 7);
    result.samples[0] -= 1.0;
    return result;
}

double mean_square(const std::vector<double>& samples) {
    return std::inner_product(samples.begin(), samples.end(), samples.begin(), 0.0) /
           static_cast<double>(samples.size());
}

TEST(Fourier, ThereAndBackIsTheSame) {
    for (const std::size_t size : {2u, 8u, 16u, 30u, 32u, 64u, 128u, 2048u, 4096u, 9600u}) {
        Fourier fourier(size);
        const Signal signal = noise(1.0, static_cast<double>(size) / 48000.0);
        const auto spectrum = fourier.spectrum(signal.samples);
        const std::vector<std::complex<double>> kept(spectrum.begin(), spectrum.end());
        const auto frame = fourier.frame(kept);
        for (std::size_t n = 0; n < frame.size(); ++n)
            EXPECT_NEAR(frame[n], signal.samples[n], 1e-14) << size;
    }
}

// whether a power of two, half of it one of four or not, or none
TEST(Fourier, AgreesWithTheDefinition) {
    for (const std::size_t size : {2u, 8u, 16u, 30u, 32u, 64u, 128u, 1024u}) {
        Fourier fourier(size);
        const Signal signal = noise(1.0, static_cast<double>(size) / 48000.0);
        const auto spectrum = fourier.spectrum(signal.samples);
        for (std::size_t k = 0; k < spectrum.size(); ++k) {
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n < size; ++n) {
                const auto turn =
                    base::sine_cosine_of_turns(static_cast<double>(k * n % size) / static_cast<double>(size));
                sum += signal.samples[n] * std::complex<double>(turn.cosine, -turn.sine);
            }
            EXPECT_NEAR(std::abs(spectrum[k] - sum), 0.0, 1e-15 * static_cast<double>(size) + 1e-14)
                << size << ' ' << k;
        }
    }
}

// whatever the processor's width, of whatever number of lines
TEST(Powers, AreTheSquaresOfLinesBitForBit) {
    std::vector<std::complex<double>> lines;
    for (std::size_t count = 0; count < 40; ++count) {
        std::vector<double> powers(count);
        powers_of(lines, powers);
        for (std::size_t k = 0; k < count; ++k)
            EXPECT_EQ(powers[k], lines[k].real() * lines[k].real() + lines[k].imag() * lines[k].imag()) << k;
        const double angle = 0.7 * static_cast<double>(count);
        lines.emplace_back(std::exp(angle) * std::cos(angle), std::exp(-angle) * std::sin(angle));
    }
}

TEST(Welch, OneRectangularFrameObeysParseval) {
    Signal signal = noise(1.0, 1.0);
    signal.samples.resize(1024);
    const Spectrum spectrum = welch(signal, {1024, Window::rectangular});
    double sum = 0.0;
    for (const double density : spectrum.density)
        sum += density * spectrum.spacing;
    EXPECT_NEAR(sum, mean_square(signal.samples), 1e-13);
    EXPECT_EQ(spectrum.frames, 1u);
}

TEST(Welch, WhiteNoiseHasItsMeanSquareSpreadEvenly) {
    const Signal signal = noise(0.5, 20.0);
    const Spectrum spectrum = welch(signal);
    // 468 frames: a band of 100 lines is known to about 0.5 %
    EXPECT_NEAR(mean_square_between(spectrum, 0.0, 24000.0), 0.25, 0.25 * 0.01);
    EXPECT_NEAR(mean_square_between(spectrum, 4000.0, 10000.0), 0.25 / 4.0, 0.25 / 4.0 * 0.02);
}

TEST(Welch, ATonesLineHasItsMeanSquareWhateverTheWindow) {
    for (const Window kind : {Window::rectangular, Window::hann, Window::blackman_harris, Window::flat_top}) {
        const Spectrum spectrum = welch(tone(1500.0, 2.0, 1.0), {4096, kind});  // on line 128
        EXPECT_NEAR(line_squares(spectrum)[128], 2.0, 1e-9);
    }
}

TEST(Welch, HasTheSameFramesInBlocksOfAnySize) {
    const Signal signal = with_noise(tone(1000.0, 1.0, 0.1), 20.0, 5);
    const Spectrum whole = welch(signal, {512, Window::hann});
    ASSERT_GT(whole.frames, 10U);
    for (const std::size_t block : {1U, 100U, 256U, 511U, 512U, 513U, 1300U}) {
        Welch average(signal.rate, {512, Window::hann});
        const std::span<const double> samples(signal.samples);
        for (std::size_t first = 0; first < samples.size(); first += block)
            average.push(samples.subspan(first, std::min(block, samples.size() - first)));
        EXPECT_EQ(average.spectrum().frames, whole.frames);
        EXPECT_EQ(average.spectrum().density, whole.density);
    }
}

TEST(Median, IsTheMiddleOfFewAndOfMany) {
    std::mt19937 random(1);
    for (const std::size_t count : {1U, 2U, 12U, 96U, 97U, 1001U}) {
        std::vector<double> values(count);
        for (double& value : values)
            value = static_cast<double>(random());
        const double median = median_of(values);
        std::sort(values.begin(), values.end());
        EXPECT_EQ(median, values[count / 2]);
    }
}

TEST(Welch, AShortSignalKeepsItsMeanSquare) {
    const Signal signal = tone(1000.0, 1.0, 0.02);
    const Spectrum spectrum = welch(signal);
    EXPECT_NEAR(mean_square_between(spectrum, 0.0, 24000.0), 0.5, 0.01);
}

TEST(Peaks, StandWhereTonesAreBetweenLines) {
    Signal signal = tone(1234.5, 1.0, 2.0);
    const Signal other = tone(3000.2, 0.1, 2.0);
    for (std::size_t n = 0; n < signal.samples.size(); ++n)
        signal.samples[n] += other.samples[n];
    const auto peaks = strongest_peaks(welch(with_noise(signal, 40.0, 1)));
    ASSERT_GE(peaks.size(), 2u);
    EXPECT_NEAR(peaks[0].frequency, 1234.5, 0.5);
    EXPECT_NEAR(peaks[1].frequency, 3000.2, 0.5);
    EXPECT_NEAR(10.0 * std::log10(peaks[0].mean_square / 0.5), 0.0, 0.2);
    EXPECT_NEAR(10.0 * std::log10(peaks[1].mean_square / 0.005), 0.0, 0.3);
}

TEST(Bands, ThirdOctavesAddUpToTheirOctaveAndToneFallsIntoOne) {
    const Spectrum spectrum = welch(noise(1.0, 5.0));
    const auto octaves = bands(spectrum, BandWidth::octave);
    const auto thirds = bands(spectrum, BandWidth::third_octave);
    const auto find = [](const std::vector<Band>& list, double nominal) {
        for (const Band& band : list)
            if (band.nominal == nominal) return band;
        return Band{};
    };
    EXPECT_NEAR(find(octaves, 1000.0).mean_square,
                find(thirds, 800.0).mean_square + find(thirds, 1000.0).mean_square + find(thirds, 1250.0).mean_square,
                1e-12);
    EXPECT_NEAR(find(thirds, 1000.0).low, 891.2509381, 1e-6);  // 10^2.95
    const auto of_tone = bands(welch(tone(500.0, 1.0, 2.0)), BandWidth::third_octave);
    EXPECT_NEAR(find(of_tone, 500.0).mean_square, 0.5, 1e-3);
    EXPECT_LT(find(of_tone, 800.0).mean_square, 1e-6);
}

TEST(AWeighting, HasTheStandardsValues) {
    // IEC 61672-1, table 3, which is rounded to 0.1 dB at nominal frequencies
    const auto level = [](double frequency) { return 10.0 * std::log10(a_weighting(frequency)); };
    EXPECT_NEAR(level(31.622776601683793), -39.4, 0.06);
    EXPECT_NEAR(level(100.0), -19.1, 0.06);
    EXPECT_NEAR(level(1000.0), 0.0, 1e-12);
    EXPECT_NEAR(level(3981.0717055349725), 1.0, 0.06);
    EXPECT_NEAR(level(15848.93192461114), -6.6, 0.1);
}

TEST(Level, OfOnePascalEffectiveIs94Decibels) {
    LevelMeter meter(48000.0, reference_of("Pa"));
    const Signal signal = tone(1000.0, std::sqrt(2.0), 2.0);
    meter.push(signal.samples);
    EXPECT_NEAR(meter.history().greatest, 93.98, 0.05);
    // after one time constant 1 - 1/e of the power is there: -1.99 dB
    EXPECT_NEAR(meter.history().decibels[1] - 93.98, 10.0 * std::log10(1.0 - std::exp(-0.1 / fast)), 0.06);
}

TEST(Level, UnitsHaveTheirReferences) {
    EXPECT_EQ(level_unit("Pa"), "dB re 20 uPa");
    EXPECT_EQ(level_unit("m/s"), "dB re 1e-9 m/s");
    EXPECT_EQ(level_unit("FS"), "dB re FS");
}

TEST(Filter, ButterworthHasItsCornerAndItsSlope) {
    const auto low = low_pass(1000.0, 48000.0, 4);
    EXPECT_NEAR(gain_at(low, 1000.0, 48000.0), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(gain_at(low, 0.0, 48000.0), 1.0, 1e-12);
    EXPECT_NEAR(20.0 * std::log10(gain_at(low, 4000.0, 48000.0)), -48.2, 1.0);
    EXPECT_NEAR(gain_at(high_pass(40.0, 48000.0, 2), 40.0, 48000.0), std::sqrt(0.5), 1e-9);
}

TEST(Filter, WhatComesOutIsWhatItsResponseSays) {
    const auto sections = high_pass(500.0, 48000.0, 4);
    const std::vector<double> through = filtered(tone(700.0, 1.0, 1.0).samples, sections);
    const std::vector<double> late(through.begin() + 24000, through.end());
    EXPECT_NEAR(std::sqrt(2.0 * mean_square(late)), gain_at(sections, 700.0, 48000.0), 1e-3);
}

TEST(Resample, AToneStaysTheSameTone) {
    const Signal there = resampled(tone(1000.0, 1.0, 0.5, 44100.0), 48000.0);
    const Signal expected = tone(1000.0, 1.0, 0.5, 48000.0);
    ASSERT_EQ(there.samples.size(), expected.samples.size());
    for (std::size_t n = 2000; n < 22000; n += 37)
        EXPECT_NEAR(there.samples[n], expected.samples[n], 2e-4);
}

TEST(Resample, WhatTheLowerRateCannotHoldIsGone) {
    const Signal there = resampled(tone(9000.0, 1.0, 0.5, 48000.0), 16000.0);
    const std::vector<double> middle(there.samples.begin() + 1000, there.samples.end() - 1000);
    EXPECT_LT(10.0 * std::log10(mean_square(middle) / 0.5), -80.0);
}

TEST(Noise, HasTheRatioAskedForAndTheSameBits) {
    const Signal signal = tone(1000.0, 1.0, 2.0);
    const Signal noisy = with_noise(signal, 10.0, 3);
    std::vector<double> added;
    for (std::size_t n = 0; n < signal.samples.size(); ++n)
        added.push_back(noisy.samples[n] - signal.samples[n]);
    EXPECT_NEAR(10.0 * std::log10(0.5 / mean_square(added)), 10.0, 0.1);
    EXPECT_EQ(noisy.samples, with_noise(signal, 10.0, 3).samples);
    EXPECT_NE(noisy.samples, with_noise(signal, 10.0, 4).samples);
}

TEST(Spectrograph, StaysBoundedAndKeepsThePower) {
    const Signal signal = tone(3000.0, 1.0, 60.0, 8000.0);
    const Spectrogram graph = spectrogram(signal, 256);
    EXPECT_LE(graph.columns(), SpectrogramBounds{}.columns);
    EXPECT_NEAR(graph.column * static_cast<double>(graph.columns()), 60.0, 0.2);
    double sum = 0.0;
    for (std::size_t row = 0; row < graph.rows; ++row)
        sum += graph.density[row] * graph.row;
    EXPECT_NEAR(sum, 0.5, 1e-6);
}

TEST(Spectrograph, PutsAnImpulseIntoTheColumnsAroundIt) {
    Signal knock{8000.0, "FS", std::vector<double>(8000)};
    knock.samples[4000] = 1.0;
    const Spectrogram graph = spectrogram(knock, 64);
    double weight = 0.0;
    double moment = 0.0;
    for (std::size_t column = 0; column < graph.columns(); ++column) {
        const double here = graph.density[column * graph.rows + 10];
        weight += here;
        moment += here * (graph.from + (static_cast<double>(column) + 0.5) * graph.column);
    }
    EXPECT_NEAR(moment / weight, 0.5, 0.5 * graph.column);
}

}  // namespace
}  // namespace stridor::signal
