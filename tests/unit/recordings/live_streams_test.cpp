// Sounds that are not over: the heads that other programs write into a pipe, bare samples, what recorders say.

#include "stridor/recordings/live/byte_flow.hpp"
#include "stridor/recordings/live/recorder_words.hpp"
#include "stridor/recordings/live/stream_form.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace stridor::recordings {

namespace {

using namespace std::chrono_literals;

std::string from_hex(const std::string& digits) {
    std::string bytes;
    std::string pair;
    for (const char c : digits) {
        if (c != ' ') pair += c;
        if (pair.size() < 2) continue;
        bytes += static_cast<char>(std::stoi(pair, nullptr, 16));
        pair.clear();
    }
    return bytes;
}

// what the programs of Debian 12 wrote into a pipe, up to their first sample
const std::string sox_mono =
    from_hex("5249464624f0ff7f57415645666d7420 10000000010001 0080bb00000077010002001000 6461746100f0ff7f");
const std::string sox_four = from_hex(
    "5249464644f0ff7f57415645666d7420 28000000feff040080bb000000ca08000c0018001600180033000000"
    "0100000000001000800000aa00389b71 6661637404000000 55a9aa0a 64617461fcefff7f");
const std::string ffmpeg_mono = from_hex(
    "52494646ffffffff57415645666d7420 100000000100010080bb00000077010002001000"
    "4c4953541a000000494e464f495346540e0000004c61766635392e32372e31303000 64617461ffffffff");
const std::string ffmpeg_long = from_hex(
    "52463634ffffffff5741564564733634 1c000000 00000000000000000000000000000000000000000000000000000000"
    "666d742028000000feff040080bb000000ca08000c0018001600180007010000 0100000000001000800000aa00389b71"
    "4c4953541a000000494e464f495346540e0000004c61766635392e32372e31303000 64617461ffffffff");
const std::string arecord_second =
    from_hex("5249464624ca080057415645666d7420 100000000100040080bb000000ca08000c001800 6461746100ca0800");
const std::string arecord_open =
    from_hex("524946462400008057415645666d7420 100000000300020080bb000000dc050008002000 6461746100000080");

struct WrittenHead {
    const char* program;
    std::string bytes;
    StreamForm form;
    std::optional<std::uint64_t> promised;
};

const std::vector<WrittenHead>& written_heads() {
    static const std::vector<WrittenHead> heads{
        {"sox, 16 bit", sox_mono, {SampleCoding::s16, 48000.0, 1}, {}},
        {"sox, 24 bit", sox_four, {SampleCoding::s24, 48000.0, 4}, {}},
        {"ffmpeg", ffmpeg_mono, {SampleCoding::s16, 48000.0, 1}, {}},
        {"ffmpeg, RF64", ffmpeg_long, {SampleCoding::s24, 48000.0, 4}, {}},
        {"arecord -d 1", arecord_second, {SampleCoding::s24, 48000.0, 4}, 576000},
        {"arecord", arecord_open, {SampleCoding::f32, 48000.0, 2}, {}}};
    return heads;
}

double decoded(SampleCoding coding, const std::string& hex) {
    double sample = 0.0;
    decode({coding, 48000.0, 1}, from_hex(hex), {&sample, 1});
    return sample;
}

template <typename Action>
void expect_thrown(ErrorKind kind, const std::string& words, const Action& action) {
    const support::Thrown thrown = support::thrown_by(action);
    EXPECT_EQ(thrown.kind, kind);
    EXPECT_TRUE(thrown.says(words)) << thrown.message;
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string drained(ByteFlow& flow) {
    std::string text;
    std::vector<char> block(1000);
    for (;;) {
        const Arrival arrival = flow.next(block, 1s);
        if (arrival.kind == Arrival::Kind::end) return text;
        text.append(block.data(), arrival.count);
    }
}

}  // namespace

TEST(WavStream, HasTheFormThatProgramsWrite) {
    for (const WrittenHead& written : written_heads()) {
        SCOPED_TRACE(written.program);
        const auto head = wav_stream_head(written.bytes + "samples", "pipe");
        ASSERT_TRUE(head);
        EXPECT_EQ(head->form, written.form);
        EXPECT_EQ(head->bytes, written.bytes.size());
        EXPECT_EQ(head->promised, written.promised);
    }
}

TEST(WavStream, WaitsForItsWholeHead) {
    for (const WrittenHead& written : written_heads())
        for (std::size_t size = 12; size < written.bytes.size(); ++size)
            EXPECT_FALSE(wav_stream_head(written.bytes.substr(0, size), "pipe")) << written.program << " " << size;
}

// the same head before a whole recording: what leaves its length open here does so there, too
TEST(WavStream, OfSoxIsNoRecordingThatWasCut) {
    for (const std::string& head : {sox_mono, sox_four}) {
        const auto file = open_signal({bytes_of(head + std::string(1200, '\1')), "pipe.wav", {}});
        EXPECT_EQ(signal::read_all(*file).size(), head == sox_mono ? 1u : 4u);
    }
}

TEST(WavStream, RefusesWhatItCannotRead) {
    std::string packed = sox_mono;
    packed[20] = '\x11';  // IMA ADPCM
    expect_thrown(ErrorKind::input, "format 17", [&] { wav_stream_head(packed, "pipe"); });
    std::string wide = arecord_second;
    wide[32] = '\x10';  // 24 bits in 4 bytes
    expect_thrown(ErrorKind::input, "24 bits in frames of 16 bytes", [&] { wav_stream_head(wide, "pipe"); });
    expect_thrown(ErrorKind::input, "no data chunk", [&] {
        wav_stream_head("RIFF\xff\xff\xff\xffWAVEJUNK" + from_hex("ffffff7f") + std::string(1 << 20, 'x'), "pipe");
    });
}

TEST(WavStream, TellsTheCalibrationOfItsDescription) {
    std::string text = "test drive; full scale = 2 Pa";
    text.resize(602, '\0');
    const std::string bext = "bext" + from_hex("5a020000") + text;
    const auto head = wav_stream_head(sox_mono.substr(0, 36) + bext + sox_mono.substr(36), "pipe");
    ASSERT_TRUE(head);
    EXPECT_EQ(calibration_in(head->description), (FullScale{2.0, "Pa"}));
}

TEST(BareSamples, AreNumbersOfFullScale) {
    EXPECT_EQ(decoded(SampleCoding::u8, "80"), 0.0);
    EXPECT_EQ(decoded(SampleCoding::u8, "00"), -1.0);
    EXPECT_EQ(decoded(SampleCoding::s16, "0080"), -1.0);
    EXPECT_EQ(decoded(SampleCoding::s16, "ff7f"), 32767.0 / 32768.0);
    EXPECT_EQ(decoded(SampleCoding::s24, "000080"), -1.0);
    EXPECT_EQ(decoded(SampleCoding::s24, "ffffff"), -1.0 / 8388608.0);
    EXPECT_EQ(decoded(SampleCoding::s32, "00000080"), -1.0);
    EXPECT_EQ(decoded(SampleCoding::s32, "01000000"), std::ldexp(1.0, -31));
    EXPECT_EQ(decoded(SampleCoding::f32, "0000c03f"), 1.5);
    EXPECT_EQ(decoded(SampleCoding::f64, "000000000000f83f"), 1.5);
    for (const std::string& name : sample_coding_names())
        EXPECT_EQ(StreamForm({sample_coding_of(name), 1.0, 3}).frame_bytes() % 3, 0u) << name;
    expect_thrown(ErrorKind::input, "s24le", [] { sample_coding_of("s20le"); });
}

TEST(RecorderWords, TellWhatWasLost) {
    RecorderWords words;
    EXPECT_FALSE(words.hear("Recording WAVE 'stdin' : Signed 16 bit\n"));
    EXPECT_FALSE(words.hear("overrun!!! (at least 12."));
    const auto lost = words.hear("345 ms long)\n");
    ASSERT_TRUE(lost);
    EXPECT_NEAR(lost->seconds.value_or(0.0), 0.012345, 1e-12);
    EXPECT_EQ(lost->words, "overrun!!! (at least 12.345 ms long)");
    const auto of_parec = words.hear("Time: 1.2 sec; Latency: 3 usec.  \rStream overrun.\n");
    ASSERT_TRUE(of_parec);
    EXPECT_FALSE(of_parec->seconds);
    EXPECT_FALSE(words.hear("arecord: main:831: audio open error: No such file or directory\n"));
    EXPECT_NE(words.last().find("No such file"), std::string::npos);
}

TEST(RecorderWords, MakeACommandWithoutAShell) {
    const StreamForm form{SampleCoding::s24, 48000.0, 4};
    const std::vector<std::string> alsa = recorder_command("arecord", "hw:1,0; rm", form);
    EXPECT_EQ(alsa.back(), "--device=hw:1,0; rm");
    EXPECT_NE(std::find(alsa.begin(), alsa.end(), "--format=S24_3LE"), alsa.end());
    const std::vector<std::string> pulse = recorder_command("parec", "", form);
    EXPECT_NE(std::find(pulse.begin(), pulse.end(), "--format=s24le"), pulse.end());
    expect_thrown(ErrorKind::input, "f64le", [&] { recorder_command("parec", "", {SampleCoding::f64, 48000.0, 1}); });
    expect_thrown(ErrorKind::input, "parec, arecord", [] { recorder_for("", "rec"); });
}

TEST(ByteFlow, OfAProgramEndsWithItAndTellsWhatItLost) {
    const auto flow = flow_of_program({"sh", "-c", "printf abc; echo 'overrun!!! (at least 5.0 ms long)' >&2"});
    std::vector<char> block(100);
    std::string text;
    bool is_lost = false;
    for (;;) {
        const Arrival arrival = flow->next(block, 5s);
        if (arrival.kind == Arrival::Kind::end) break;
        if (arrival.kind == Arrival::Kind::lost) is_lost = arrival.seconds == 0.005;
        text.append(block.data(), arrival.count);
    }
    EXPECT_EQ(text, "abc");
    EXPECT_TRUE(is_lost);
}

// what came before the loss is not taken for what came after it
TEST(ByteFlow, OfAProgramTellsALossBehindTheBytesBeforeIt) {
    const auto flow = flow_of_program({"sh", "-c", "head -c 50000 /dev/zero; echo 'overrun!!!' >&2"});
    std::vector<char> block(777);
    std::size_t count = 0;
    for (;;) {
        const Arrival arrival = flow->next(block, 5s);
        if (arrival.kind == Arrival::Kind::lost || arrival.kind == Arrival::Kind::end) break;
        count += arrival.count;
    }
    EXPECT_EQ(count, 50000u);
}

TEST(ByteFlow, OfAProgramThatFailsThrowsItsWords) {
    const auto flow = flow_of_program({"sh", "-c", "echo 'audio open error: no device' >&2; exit 1"});
    expect_thrown(ErrorKind::io, "no device", [&] { drained(*flow); });
    const auto endless = flow_of_program({"sh", "-c", "while :; do printf x; done"});
    std::vector<char> block(100);
    EXPECT_EQ(endless->next(block, 5s).kind, Arrival::Kind::bytes);  // and it is ended with this object
}

TEST(ByteFlow, OfAFileThatGrowsSeesItCutReplacedAndRemoved) {
    const support::ScratchFolder folder;
    const std::filesystem::path file = folder / "growing.wav";
    std::vector<char> block(100);
    const auto opened = [&] {
        write(file, "0123456789");
        auto flow = flow_of_growing_file(file.string());
        EXPECT_EQ(flow->next(block, 0ms).count, 10u);
        EXPECT_EQ(flow->next(block, 0ms).kind, Arrival::Kind::nothing);
        return flow;
    };
    const auto cut = opened();
    std::filesystem::resize_file(file, 4);
    EXPECT_NE(cut->next(block, 0ms).words.find("cut"), std::string::npos);
    const auto removed = opened();
    std::filesystem::remove(file);
    EXPECT_NE(removed->next(block, 0ms).words.find("removed"), std::string::npos);
    const auto replaced = opened();
    write(folder / "other", "0123456789abc");
    std::filesystem::rename(folder / "other", file);
    EXPECT_NE(replaced->next(block, 0ms).words.find("another file"), std::string::npos);
    expect_thrown(ErrorKind::input, "not a file", [&] { flow_of_growing_file(folder.path().string()); });
    expect_thrown(ErrorKind::io, "No such file", [&] { flow_of_growing_file((folder / "no").string()); });
}

}  // namespace stridor::recordings
