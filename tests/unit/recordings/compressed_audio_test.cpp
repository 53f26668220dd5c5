#include "stridor/recordings/audio/compressed_audio.hpp"

#include "signal_support.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/expected_error.hpp"
#include "support/needs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stridor::recordings {

using support::error_of;
namespace {

using signal::Signal;

// of the fixtures: a sine of 1 kHz with the amplitude 0.5 lasts 0.4 s
constexpr double sine_frequency = 1000.0;  // [Hz]
constexpr double sine_amplitude = 0.5;     // [1]
constexpr double sine_duration = 0.4;      // [s]

// the machine may lack ffmpeg's libraries, and so may the build
bool lacks_ffmpeg() {
    try {
        open_signal(fixture("phone.m4a"));
    } catch (const Error& error) {
        return error.problem().why.find("ffmpeg's libraries") != std::string::npos;
    }
    return false;
}

#define NEEDS_FFMPEG() STRIDOR_NEEDS(!lacks_ffmpeg(), "A library of ffmpeg's", "ffmpeg libavformat-dev")

struct Sine {
    double amplitude = 0.0;
    double rest = 0.0;  // [1] rms of what is no such sine, over the sine's
};

// from 0.1 s to 0.3 s, 200 periods: least squares
Sine sine_in(const Signal& signal) {
    const auto first = static_cast<std::size_t>(0.1 * signal.rate);
    const auto count = static_cast<std::size_t>(0.2 * signal.rate);
    double cosine = 0.0, sine = 0.0, energy = 0.0;
    for (std::size_t k = first; k < first + count; ++k) {
        const double phase = 2.0 * std::numbers::pi * sine_frequency * static_cast<double>(k) / signal.rate;
        cosine += signal.samples[k] * std::cos(phase);
        sine += signal.samples[k] * std::sin(phase);
        energy += signal.samples[k] * signal.samples[k];
    }
    const double amplitude = 2.0 * std::hypot(cosine, sine) / static_cast<double>(count);
    const double of_sine = 0.5 * amplitude * amplitude * static_cast<double>(count);
    return {amplitude, std::sqrt(std::max(0.0, energy - of_sine) / of_sine)};
}

/// A codec rounds: 1 % of the level, that of telephones 10 %; LAME takes 5 % off at low bit rates. `spare` [s] is what
/// it may leave before and behind the sound.
void expect_sine(const std::string& name, double rate, double spare, double full_scale = 1.0) {
    const std::vector<Signal> found = all_of(fixture(name));
    ASSERT_EQ(found.size(), 1U) << name;
    EXPECT_EQ(found[0].rate, rate) << name;
    EXPECT_GE(signal::duration(found[0]), sine_duration - 1.0 / rate) << name;
    EXPECT_LE(signal::duration(found[0]), sine_duration + spare) << name;
    const Sine sine = sine_in(found[0]);
    const double tolerance = rate < 16000.0 ? 0.1 : 0.06;
    EXPECT_NEAR(sine.amplitude / full_scale, sine_amplitude, tolerance * sine_amplitude) << name;
    EXPECT_LT(sine.rest, 2.0 * tolerance) << name;
}

TEST(Mp3, OfOrdinaryEncodersIsRead) {
    expect_sine("lame_vbr.mp3", 48000.0, 0.0);
    expect_sine("browser.opus", 48000.0, 0.0);
}

TEST(Mp3, ThatDoesNotTellItsLengthIsReadToItsEnd) {
    // what the encoder adds is not told either: at most two frames of 1152
    expect_sine("lame_cbr_no_length.mp3", 48000.0, 2304.0 / 48000.0);
    EXPECT_FALSE(open_signal(fixture("lame_cbr_no_length.mp3"))->layout().frames) << "it is a guess";
}

TEST(Mp3, ThatTellsItsLengthIsKnownToBeCutOff) {
    const std::string whole = storage::read_file(fixture("lame_vbr.mp3"));
    const auto error = error_of([&] { all_of(input_of(whole.substr(0, whole.size() / 2), "cut.mp3")); });
    ASSERT_TRUE(error);
    EXPECT_NE(error->problem().why.find("cut off"), std::string::npos) << error->what();
}

TEST(CompressedAudio, OfPhonesAndBrowsersIsRead) {
    NEEDS_FFMPEG();
    expect_sine("phone.m4a", 48000.0, 1024.0 / 48000.0, 2.0);
    expect_sine("phone.3gp", 16000.0, 1024.0 / 16000.0);
    expect_sine("phone.amr", 8000.0, 160.0 / 8000.0);
    expect_sine("browser.webm", 48000.0, 960.0 / 48000.0);
    expect_sine("stream.aac", 48000.0, 2048.0 / 48000.0);  // its encoder's delay is told nowhere
}

TEST(CompressedAudio, KeepsTheLevelOfItsComment) {
    NEEDS_FFMPEG();
    const auto file = open_signal(fixture("phone.m4a"));
    EXPECT_EQ(file->layout().channels[0].unit, "Pa");
    EXPECT_EQ(file->facts().format, "MPEG-4, aac");
}

TEST(CompressedAudio, WithoutLossKeepsEveryBit) {
    NEEDS_FFMPEG();
    const std::vector<Signal> found = all_of(fixture("lossless.m4a"));
    ASSERT_EQ(found[0].samples.size(), 4800U);
    for (std::size_t k = 0; k < found[0].samples.size(); ++k) {
        const double exact =
            sine_amplitude * std::sin(2.0 * std::numbers::pi * sine_frequency * static_cast<double>(k) / 48000.0);
        EXPECT_NEAR(found[0].samples[k], exact, 0x1p-15) << k;
    }
}

TEST(CompressedAudio, CutOffOrDamagedIsRefused) {
    NEEDS_FFMPEG();
    for (const char* name : {"phone.m4a", "phone.3gp", "browser.webm", "lossless.m4a"}) {
        const std::string whole = storage::read_file(fixture(name));
        for (const std::size_t length : {std::size_t{12}, std::size_t{100}}) {
            const auto error = error_of([&] { all_of(input_of(whole.substr(0, length), name)); });
            EXPECT_TRUE(error && error->place()) << name << " of " << length << " bytes";
        }
    }
    // the index of an MPEG-4 file stands behind its sound
    const std::string whole = storage::read_file(fixture("lossless.m4a"));
    EXPECT_TRUE(error_of([&] { all_of(input_of(whole.substr(0, whole.size() / 2))); }));
}

TEST(CompressedAudio, IsNoPlaylist) {
    for (const char* beginning : {"#EXTM3U\n#EXT-X-VERSION:3\n", "ffconcat version 1.0\nfile x\n", "[playlist]\n",
                                  "<?xml version=\"1.0\"?><MPD", "RIFF\0\0\0\0WAVE", "v=0\no=- 0 0 IN IP4"})
        EXPECT_FALSE(is_compressed_audio(beginning)) << beginning << " may name other files";
}

}  // namespace
}  // namespace stridor::recordings
