#include "stridor/recordings/open_signal.hpp"

#include "signal_support.hpp"
#include "stridor/io/sound/signal_report.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/sidecar.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/counter_random.hpp"
#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
using support::ScratchFolder;
namespace {

using signal::Signal;

constexpr int fixture_frames = 64;

// left of the fixtures made of scipy_16.wav: (512 k - 16384) / 32768
double rising(int k) {
    return (512.0 * k - 16384.0) / 32768.0;
}

TEST(OpenSignal, ReadsWhatScipyWrote) {
    const std::vector<Signal> stereo = all_of(fixture("scipy_16.wav"));
    ASSERT_EQ(stereo.size(), 2U);
    EXPECT_EQ(stereo[0].rate, 48000.0);
    EXPECT_EQ(stereo[0].unit, signal::full_scale);
    ASSERT_EQ(stereo[0].samples.size(), 64U);
    for (int k = 0; k < fixture_frames; ++k) {
        EXPECT_EQ(stereo[0].samples[static_cast<std::size_t>(k)], rising(k));
        EXPECT_EQ(stereo[1].samples[static_cast<std::size_t>(k)], -rising(k));
    }
    const std::vector<Signal> wide = all_of(fixture("scipy_int32.wav"));
    EXPECT_EQ(wide[0].samples[1], -31.0 / 32.0);
    const std::vector<Signal> single = all_of(fixture("scipy_float.wav"));
    EXPECT_EQ(single[0].rate, 51200.0);
    EXPECT_EQ(single[0].samples[4], 0.75);
    EXPECT_EQ(single[0].samples[12], -0.75);
}

TEST(OpenSignal, ReadsWhatSoxWroteInEveryLosslessFormat) {
    for (const char* name : {"sox_24.wav", "sox.flac", "sox.aiff", "sox.w64", "sox.au", "sox_piped.wav"}) {
        const std::vector<Signal> stereo = all_of(fixture(name));
        ASSERT_EQ(stereo.size(), 2U) << name;
        ASSERT_EQ(stereo[0].samples.size(), 64U) << name;
        EXPECT_EQ(stereo[0].rate, 48000.0) << name;
        for (int k = 0; k < fixture_frames; ++k)
            EXPECT_EQ(stereo[0].samples[static_cast<std::size_t>(k)], rising(k)) << name;
    }
}

TEST(OpenSignal, SaysHowMeasurementsOfOtherProgramsGetIn) {
    const auto refusal_of = [](const std::string& bytes) { return error_of([&] { open_signal(input_of(bytes)); }); };
    for (const auto& [beginning, name] :
         {std::pair{std::string("TDSm\x0e\0\0\0", 8), "TDMS"}, std::pair{std::string("MDF     4.10    "), "MDF"},
          std::pair{std::string("\x89HDF\r\n\x1a\n\0", 9), "HDF5"}}) {
        const auto error = refusal_of(beginning);
        ASSERT_TRUE(error);
        EXPECT_NE(error->problem().what.find(name), std::string::npos) << error->what();
        EXPECT_FALSE(error->problem().suggestion.empty());
    }
}

TEST(OpenSignal, ReadsVorbisUpToItsLoss) {
    const std::vector<Signal> left = all_of(fixture("sox.ogg"));
    ASSERT_EQ(left.size(), 1U);
    ASSERT_EQ(left[0].samples.size(), 64U);
    for (int k = 0; k < fixture_frames; ++k)
        EXPECT_NEAR(left[0].samples[static_cast<std::size_t>(k)], rising(k), 0.1);
}

TEST(OpenSignal, SaysThatAPipedHeaderKnowsNoLength) {
    const auto file = open_signal(fixture("sox_piped.wav"));
    ASSERT_EQ(file->facts().notes.size(), 1U);
    EXPECT_NE(file->facts().notes[0].find("does not say how long"), std::string::npos);
}

// a recorder that lost its power leaves 0; the last two have a header that no library takes
TEST(OpenSignal, ReadsTheSamplesThatAreThereWhateverTheHeaderSays) {
    for (const char* name :
         {"21_size_0.wav", "21_rf64_size_0.wav", "21_apple_size_0.wav", "22_list_with_filling.wav", "27_bw64.wav"}) {
        const auto file = open_signal(fixture(name));
        EXPECT_EQ(file->layout().rate, 48000.0) << name;
        EXPECT_EQ(file->facts().notes.size(), std::string_view(name) == "27_bw64.wav" ? 0U : 1U) << name;
        const std::vector<Signal> found = signal::read_all(*file);
        ASSERT_EQ(found.size(), 1U) << name;
        ASSERT_EQ(found[0].samples.size(), 4800U) << name;
        const auto [low, high] = std::minmax_element(found[0].samples.begin(), found[0].samples.end());
        EXPECT_NEAR(*high, 0.5, 1e-3) << name;
        EXPECT_NEAR(*low, -0.5, 1e-3) << name;
    }
}

std::string bytes(std::uint32_t value, int count) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += static_cast<char>(value >> (8 * k) & 0xFFU);
    return text;
}

TEST(OpenSignal, Reads24BitsThatStandIn4Bytes) {
    constexpr std::array<std::int32_t, 4> samples{1, -1, 4194304, -8388607};
    for (const bool is_low : {false, true}) {
        std::string data;
        for (const std::int32_t sample : samples)
            data += bytes(static_cast<std::uint32_t>(is_low ? sample : sample * 256), 4);
        const std::string wav = "RIFF" + bytes(52, 4) + "WAVEfmt " + bytes(16, 4) + bytes(1, 2) + bytes(1, 2) +
                                bytes(48000, 4) + bytes(192000, 4) + bytes(4, 2) + bytes(24, 2) + "data" +
                                bytes(16, 4) + data;
        const std::vector<Signal> found = all_of(input_of(wav));
        ASSERT_EQ(found[0].samples.size(), 4U) << is_low;
        for (std::size_t k = 0; k < samples.size(); ++k)
            EXPECT_EQ(found[0].samples[k], samples[k] / 8388608.0) << is_low;
    }
}

// half of the bytes of soft samples beside a DC offset are NUL, as those of a text in UTF-16 are
TEST(OpenSignal, TakesSoftSamplesForNoText) {
    constexpr int frames = 3000;
    for (const std::uint32_t offset : {48U, 100U, 0x4000U}) {
        std::string data;
        for (std::uint32_t k = 0; k < frames; ++k)
            data += bytes(offset + k % 5, 2);
        const std::string wav = "RIFF" + bytes(36 + 2 * frames, 4) + "WAVEfmt " + bytes(16, 4) + bytes(1, 2) +
                                bytes(1, 2) + bytes(48000, 4) + bytes(96000, 4) + bytes(2, 2) + bytes(16, 2) + "data" +
                                bytes(2 * frames, 4) + data;
        const std::vector<Signal> found = all_of(input_of(wav));
        ASSERT_EQ(found[0].samples.size(), frames) << offset;
        EXPECT_EQ(found[0].samples[1], (offset + 1) / 32768.0);
    }
}

TEST(OpenSignal, NamesTheFrameThatIsNotFinite) {
    expect_error(error_of([] { all_of(fixture("scipy_nan.wav")); }), "sample 41 is nan", fixture("scipy_nan.wav"));
}

// the square of 1e200 is no double, nor is any level that it enters
TEST(OpenSignal, RefusesASampleThatIsTooLargeWithItsPlace) {
    const auto table = [](const std::string& first) { return "# rate: 8000\np [Pa]\n0.5\n" + first + "\n0.25\n"; };
    EXPECT_EQ(all_of(input_of(table("9e14"), "d.csv")).front().samples.size(), 3U);
    expect_error(error_of([&] { all_of(input_of(table("-1e200"), "d.csv")); }),
                 "p = \"-1e200\" is no finite sample (instruments write such numbers for an overload", "d.csv:4:1");
    // what a calibration makes too large, too
    OpenOptions options;
    options.full_scales = {{1e21, "Pa"}};
    expect_error(error_of([&] { all_of(input_of(table("1e14"), "d.csv"), options); }),
                 "sample 2 of the channel \"p\" is 1e+35 Pa (nothing that is measured exceeds 1e+30)", "d.csv");
}

TEST(OpenSignal, TakesOneChannelAlone) {
    OpenOptions options;
    options.channel = 2;
    options.full_scales = {{1.0, "N"}, {4.0, "Pa"}};
    const std::vector<Signal> right = all_of(fixture("scipy_16.wav"), options);
    ASSERT_EQ(right.size(), 1U);
    EXPECT_EQ(right[0].unit, "Pa");
    EXPECT_EQ(right[0].samples[0], 2.0);
    options.channel.reset();
    options.channel_name = "2";
    EXPECT_EQ(all_of(fixture("scipy_16.wav"), options)[0].samples[0], 2.0);
    options.channel_name = "left";
    expect_error(error_of([&] { open_signal(fixture("scipy_16.wav"), options); }), "there is no channel \"left\"",
                 fixture("scipy_16.wav"));
    options.channel_name.clear();
    options.channel = 3;
    expect_error(error_of([&] { open_signal(fixture("scipy_16.wav"), options); }), "there is no channel 3",
                 fixture("scipy_16.wav"));
}

TEST(OpenSignal, TakesNoNumberForAName) {
    const auto file = open_signal(input_of("# rate: 9\nchannel 1,channel 1\n1,2\n"));
    EXPECT_EQ(file->layout().channels[0].name, "");
    EXPECT_EQ(file->layout().channels[1].name, "channel 1");
}

TEST(OpenSignal, RefusesWhatIsNoRecording) {
    const ScratchFolder scratch;
    const std::array<std::pair<const char*, std::string>, 6> cases{
        {{"empty.wav", ""},
         {"text.wav", "this is text, no sound\n1,2\n"},
         {"noise.bin", std::string("\x01\x02\x03\0\x05\x06", 6)},
         {"picture.png", std::string("\x89PNG\r\n\x1a\n\0\0", 10)},
         {"cut.wav", "RIFF"},
         {"head.wav", storage::read_file(fixture("scipy_16.wav")).substr(0, 44)}}};
    for (const auto& [name, bytes] : cases) {
        storage::write_file((scratch / name).string(), bytes);
        const auto error = error_of([&, path = (scratch / name).string()] { all_of(path); });
        ASSERT_TRUE(error) << name;
        EXPECT_EQ(error->kind(), ErrorKind::input) << name;
        EXPECT_EQ(error->place()->file, (scratch / name).string()) << error->what();
    }
    expect_error(error_of([&] { all_of((scratch / "text.wav").string()); }), "this is text and no sound",
                 (scratch / "text.wav").string());
    EXPECT_EQ(error_of([&] { all_of((scratch / ".").string()); })->kind(), ErrorKind::io);
    EXPECT_EQ(error_of([&] { all_of((scratch / "missing.wav").string()); })->kind(), ErrorKind::io);
}

std::string patched(std::string bytes, std::size_t offset, std::string_view with) {
    return bytes.replace(offset, with.size(), with);
}

TEST(OpenSignal, HoldsWhatAHeaderClaimsAgainstTheFile) {
    using namespace std::string_literals;
    using namespace std::string_view_literals;
    const std::string whole = storage::read_file(fixture("scipy_16.wav"));
    const auto refusal = [](const std::string& bytes) { return error_of([&] { all_of(input_of(bytes, "lie.wav")); }); };
    expect_error(refusal(patched(whole, 40, "\0\0\0\x77"sv)), "the WAV file is cut off", "lie.wav");
    expect_error(refusal(whole.substr(0, 200)), "the WAV file is cut off", "lie.wav");
    expect_error(refusal(patched(whole, 22, "\0\0"sv)), "0 channels", "lie.wav");
    expect_error(refusal(patched(whole, 24, "\0\0\0\0"sv)), "a rate of 0 Hz", "lie.wav");
    EXPECT_TRUE(refusal(patched(whole, 24, "\xff\xff\xff\x7f"sv)));  // 2 GHz
    EXPECT_TRUE(refusal(patched(whole, 34, "\1\0"sv)));              // one bit
    EXPECT_TRUE(refusal(storage::read_file(fixture("sox.flac")).substr(0, 100)));
    EXPECT_TRUE(refusal("RIFF\x24\0\0\0WAVEfmt "s + std::string(20, '\0')));
}

// libsndfile is not ours, but what it makes of damage must still end well; not tried with Ogg, as its release 1.2.0
// never frees the decoder of an Ogg file that it refuses, and a sanitizer counts that
TEST(OpenSignal, SurvivesDamagedSoundFiles) {
    for (const char* name : {"scipy_16.wav", "sox_24.wav", "sox.flac", "sox.aiff", "sox.w64", "sox.au"}) {
        const std::string whole = storage::read_file(fixture(name));
        for (std::uint64_t run = 0; run < 150; ++run) {
            support::CounterRandom random(run);
            std::string bytes = whole;
            for (std::size_t edit = 0; edit < 1 + random.below(4); ++edit)
                bytes[random.below(std::min<std::size_t>(bytes.size(), 200))] = static_cast<char>(random.next());
            if (random.one_in(3)) bytes.resize(random.below(bytes.size()));
            try {
                const auto file = open_signal(input_of(bytes, name));
                ASSERT_LE(file->layout().channels.size(), 1024U);
                signal::read_all(*file, 1U << 22U);
            } catch (const Error& error) {
                ASSERT_EQ(error.kind(), ErrorKind::input) << name << " run " << run << ": " << error.what();
            }
        }
    }
}

Signal noise(double rate, const std::string& unit, std::uint64_t seed) {
    support::CounterRandom random(seed);
    Signal signal{rate, unit, {}};
    for (int k = 0; k < 40000; ++k)
        signal.samples.push_back(random.between(-1.0, 1.0));
    return signal;
}

double grid(double value, double steps) {
    return std::nearbyint(value * steps) / steps;
}

TEST(WriteWav, GivesBackEveryBit) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    for (const auto& [samples, steps] : {std::pair{WavSamples::pcm_16, 0x1p15}, std::pair{WavSamples::pcm_24, 0x1p23},
                                         std::pair{WavSamples::float_32, 0.0}}) {
        Signal left = noise(44100.0, "FS", 1), right = noise(44100.0, "FS", 2);
        for (Signal* channel : {&left, &right})
            for (double& x : channel->samples)
                x = steps > 0.0 ? std::min(grid(x, steps), 1.0 - 1.0 / steps)
                                : static_cast<double>(static_cast<float>(x));
        const WavWritten written = write_wav(path, *signal::source_of({left, right}), {samples, {}, ""});
        EXPECT_EQ(written.frames, 40000U);
        EXPECT_EQ(written.clipped, 0U);
        const std::vector<Signal> back = all_of(path);
        ASSERT_EQ(back.size(), 2U);
        EXPECT_EQ(back[0].samples, left.samples);
        EXPECT_EQ(back[1].samples, right.samples);
        EXPECT_EQ(scratch.files(), 1) << "nothing to say, no sidecar";
    }
}

TEST(WriteWav, ReturnsASoundFileToItsBytes) {
    const ScratchFolder scratch;
    OpenOptions options;
    options.full_scales = {parse_full_scale("0.3 Pa")};
    for (const auto& [name, samples] :
         {std::pair{"scipy_16.wav", WavSamples::pcm_16}, std::pair{"sox_24.wav", WavSamples::pcm_24}}) {
        write_wav((scratch / "b.wav").string(), *open_signal(fixture(name), options),
                  {samples, options.full_scales, ""});
        const std::vector<Signal> back = all_of((scratch / "b.wav").string());
        const std::vector<Signal> first = all_of(fixture(name), options);
        EXPECT_EQ(back[0].samples, first[0].samples) << name;
        EXPECT_EQ(back[0].unit, "Pa");
    }
}

TEST(WriteWav, CutsToFullScaleAndSaysSo) {
    const ScratchFolder scratch;
    Signal loud{8000.0, "N", {0.5, 2.0, -3.0, 1.0, -1.0}};
    const WavWritten written =
        write_wav((scratch / "a.wav").string(), *signal::source_of({loud}), {WavSamples::pcm_16, {}, ""});
    EXPECT_EQ(written.clipped, 2U);
    const std::vector<Signal> back = all_of((scratch / "a.wav").string());
    EXPECT_EQ(back[0].unit, "N");
    EXPECT_EQ(back[0].samples, (std::vector<double>{0.5, 1.0 - 0x1p-15, -1.0, 1.0 - 0x1p-15, -1.0}));
}

TEST(WriteWav, KeepsNamesUnitsScalesAndRateBesideItself) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    Signal force{48000.5, "N", {0.0, 10.0, -20.0}}, sound{48000.5, "Pa", {0.5, 1.0, -1.0}};
    write_wav(path, *signal::source_of({force, sound}), {WavSamples::float_32, {{50.0, "N"}, {2.0, "Pa"}}, ""});
    const auto file = open_signal(path);
    EXPECT_EQ(file->layout().rate, 48000.5);
    EXPECT_EQ(file->facts().full_scales, (std::vector<FullScale>{{50.0, "N"}, {2.0, "Pa"}}));
    EXPECT_EQ(file->facts().calibrations[0], Calibration::sidecar);
    const std::vector<Signal> back = signal::read_all(*file);
    EXPECT_EQ(back[1].samples, sound.samples);
    EXPECT_DOUBLE_EQ(back[0].samples[1], static_cast<double>(10.0F / 50.0F) * 50.0);
}

TEST(WriteWav, LeavesNoOldSidecarBesideANewRecording) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    write_wav(path, *signal::source_of({noise(8000.0, "Pa", 3)}));
    ASSERT_EQ(scratch.files(), 2);
    write_wav(path, *signal::source_of({noise(8000.0, "FS", 3)}));
    EXPECT_EQ(scratch.files(), 1);
    EXPECT_EQ(all_of(path)[0].unit, "FS");

    storage::write_file(path + ".json", "{\"mine\": 1}");
    EXPECT_TRUE(error_of([&] { write_wav(path, *signal::source_of({noise(8000.0, "Pa", 3)})); }));
    EXPECT_EQ(storage::read_file(path + ".json"), "{\"mine\": 1}");
}

TEST(WriteWav, HasTheSameBytesEveryTime) {
    const ScratchFolder scratch;
    for (const char* name : {"a.wav", "b.wav"})
        write_wav((scratch / name).string(), *signal::source_of({noise(8000.0, "Pa", 3)}),
                  {WavSamples::float_32, {}, "rig 7"});
    EXPECT_EQ(storage::read_file((scratch / "a.wav").string()), storage::read_file((scratch / "b.wav").string()));
}

TEST(WriteWav, RefusesWhatAWavCannotHold) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    const auto refusal = [&](const Signal& signal, const WavOptions& options = {}) {
        return error_of([&] { write_wav(path, *signal::source_of({signal}), options); });
    };
    expect_error(refusal({8000.0, "FS", {0.0, std::nan("")}}), "not a finite number", "");
    expect_error(refusal({0.25, "N", {0.0}}), "cannot have a rate of 0.25 Hz", "");
    expect_error(refusal({8000.0, "N", {1e300}}, {WavSamples::float_32, {}, ""}), "too large for single precision", "");
    expect_error(refusal({8000.0, "N", {1.0}}, {WavSamples::pcm_16, {{1.0, "Pa"}}, ""}), "does not fit", "");
    EXPECT_EQ(scratch.files(), 0);
}

// precedence: option, sidecar, description
TEST(Calibration, OfTheOptionIsStrongestThenTheSidecarThenTheDescription) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    write_wav(path, *signal::source_of({Signal{8000.0, "Pa", {0.5, 1.0}}}), {WavSamples::float_32, {{2.0, "Pa"}}, ""});
    ASSERT_TRUE(std::filesystem::exists(path + ".json"));
    storage::write_file(path + ".json", sidecar_json({{{std::nullopt, FullScale{8.0, "N"}}}, {}, {}}));
    EXPECT_EQ(all_of(path)[0].samples, (std::vector<double>{2.0, 4.0}));
    EXPECT_EQ(all_of(path)[0].unit, "N");
    OpenOptions options;
    options.full_scales = {parse_full_scale("16 m/s")};
    EXPECT_EQ(all_of(path, options)[0].samples, (std::vector<double>{4.0, 8.0}));
    std::filesystem::remove(path + ".json");
    const auto described = open_signal(path);
    EXPECT_EQ(described->facts().calibrations[0], Calibration::description);
    EXPECT_EQ(signal::read_all(*described)[0].samples, (std::vector<double>{0.5, 1.0}));
}

TEST(Calibration, OfAnotherRecordingIsRefused) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "a.wav").string();
    storage::write_file(path, storage::read_file(fixture("scipy_16.wav")));
    storage::write_file(path + ".json", sidecar_json({{{}, {}, {}}, {}, {}}));
    expect_error(error_of([&] { open_signal(path); }), "the sidecar names 3 channels", path + ".json");
    storage::write_file(path + ".json", sidecar_json({{}, 44100.0, {}}));
    expect_error(error_of([&] { open_signal(path); }), "the sidecar gives a rate of 44100 Hz", path + ".json");
}

TEST(SignalReport, KnowsTheLengthAndThePeaks) {
    const io::SignalSummary summary = io::summary_of(*open_signal(fixture("numpy.csv")));
    EXPECT_EQ(summary.layout.frames, 64U);
    EXPECT_EQ(summary.layout.rate, 44100.0);
    EXPECT_EQ(summary.layout.channels[0].unit, "N");
    EXPECT_NEAR(summary.peaks[0], 0.075, 1e-9);
    EXPECT_NE(io::convert_json(summary, std::nullopt).find("\"schema\": \"stridor.convert/1\""), std::string::npos);
}

}  // namespace
}  // namespace stridor::recordings
