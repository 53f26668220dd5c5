// A sound that is not over, from outside: pipes, files that grow, programs that record; what ends or starves them.

#include "support/counter_random.hpp"
#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::program;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

constexpr double rate = 16000.0;  // [Hz]

std::string bytes_of(std::uint32_t value, int count) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += static_cast<char>(value >> static_cast<unsigned>(8 * k) & 0xffU);
    return text;
}

// noise with a squeal from 4 to 7 s, 16 bit, one channel
std::string bare_samples(double duration) {
    stridor::support::CounterRandom random(3);
    std::string bytes;
    for (std::size_t n = 0; n < static_cast<std::size_t>(duration * rate); ++n) {
        const double t = static_cast<double>(n) / rate;
        double sum = 0.002 * random.between(-1.0, 1.0);
        for (int k = 1; k <= 8; ++k)
            sum += t >= 4.0 && t < 7.0 ? 0.1 * std::sin(6.283185307179586 * 700.0 * k * t) / k : 0.0;
        const auto number = static_cast<std::int16_t>(std::lround(32767.0 * sum));
        bytes += bytes_of(static_cast<std::uint16_t>(number), 2);
    }
    return bytes;
}

std::string wav_head(std::uint32_t data_bytes) {
    return "RIFF" + bytes_of(data_bytes == 0xFFFFFFFFU ? data_bytes : 36 + data_bytes, 4) + "WAVEfmt " +
           bytes_of(16, 4) + bytes_of(1, 2) + bytes_of(1, 2) + bytes_of(16000, 4) + bytes_of(32000, 4) +
           bytes_of(2, 2) + bytes_of(16, 2) + "data" + bytes_of(data_bytes, 4);
}

std::string wav(const std::string& samples) {
    return wav_head(static_cast<std::uint32_t>(samples.size())) + samples;
}

const std::string& drive() {
    static const std::string samples = bare_samples(14.0);
    return samples;
}

std::vector<json> events_of(const std::string& out) {
    std::vector<json> events;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);)
        events.push_back(json_of(line));
    return events;
}

std::vector<json> only(const std::vector<json>& events, const std::string& kind) {
    std::vector<json> found;
    std::copy_if(events.begin(), events.end(), std::back_inserter(found),
                 [&](const json& event) { return event["event"] == kind; });
    return found;
}

const std::vector<std::string> raw{"listen-in", "--raw", "s16le", "--rate", "16000", "--began", "2026-11-27T12:00:00Z"};

std::vector<std::string> raw_with(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = raw;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

Finished hear(const std::vector<std::string>& arguments, const ScratchFolder& folder, const std::string& input,
              const std::optional<unsigned long>& largest_file = std::nullopt) {
    return run(Launch{arguments, folder.path(), input, largest_file, {}});
}

json verdict_of_file(const ScratchFolder& folder, const std::string& samples) {
    write_text(folder / "whole.wav", wav(samples));
    return json_of(run({"classify", "whole.wav", "--json"}, folder.path()).out)["channels"][0]["verdict"];
}

void expect_refused(const Finished& finished, int exit_code, const std::string& words) {
    EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
    EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
}

/// A pipe with a name: the program reads it, the test writes into it, piece by piece.
class Pipe {
public:
    Pipe(const ScratchFolder& folder, const std::vector<std::string>& arguments)
        : path_((folder / "pipe").string()),
          made_(::mkfifo(path_.c_str(), 0600)),
          process_(Launch{words(arguments), folder.path(), {}, std::nullopt, {}, "/bin/sh"}),
          end_(::open(path_.c_str(), O_WRONLY)) {}
    ~Pipe() { close(); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void write(const std::string& bytes) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count = ::write(end_, bytes.data() + done, bytes.size() - done);
            if (count <= 0) FAIL() << "nobody reads";
            done += static_cast<std::size_t>(count);
        }
    }
    void close() {
        if (end_ >= 0) ::close(std::exchange(end_, -1));
    }
    Process& process() { return process_; }

private:
    std::vector<std::string> words(const std::vector<std::string>& arguments) const {
        std::vector<std::string> all{"-c", "exec \"$@\" < pipe > out.jsonl", "sh", program()};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return all;
    }

    std::string path_;
    int made_;
    Process process_;
    int end_;
};

// events as they are told, and not only at the end
bool tells(const ScratchFolder& folder, const std::string& words) {
    return stridor::support::wait_until([&] {
        return std::filesystem::exists(folder / "out.jsonl") &&
               read_text(folder / "out.jsonl").find(words) != std::string::npos;
    });
}

}  // namespace

TEST(ListenIn, HearsWhatClassifyHearsInAFile) {
    const ScratchFolder folder;
    const json expected = verdict_of_file(folder, drive());
    const std::vector<json> events = events_of(hear(raw_with({"--json"}), folder, drive()).out);
    ASSERT_GE(events.size(), 4u);
    EXPECT_EQ(events.front()["schema"], "stridor.listen-in/1");
    const std::vector<json> takes = only(events, "take");
    ASSERT_EQ(takes.size(), 1u);
    EXPECT_EQ(takes[0]["classify"]["channels"][0]["verdict"], expected);
    EXPECT_EQ(events.back()["event"], "end");
    EXPECT_EQ(events.back()["heard"], 14.0);
    EXPECT_EQ(events.back()["gaps"], 0);
    const std::vector<json> noises = only(events, "noise");
    ASSERT_FALSE(noises.empty());
    EXPECT_EQ(noises[0]["category"], "squeal");
    EXPECT_TRUE(noises[0]["time"].get<std::string>().starts_with("2026-11-27T12:00:0")) << noises[0];
}

// heads with and without a length, text lines
TEST(ListenIn, SaysTheSameOfWavStreams) {
    const ScratchFolder folder;
    const std::string bare = hear(raw_with({}), folder, drive()).out;
    EXPECT_NE(bare.find("noise 1: squeal"), std::string::npos) << bare;
    for (const std::uint32_t length : {0xFFFFFFFFU, 0U, 0x7FFFF000U, static_cast<std::uint32_t>(drive().size())}) {
        const Finished finished = hear({"listen-in"}, folder, wav_head(length) + drive());
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
        const std::string sum = finished.out.substr(0, finished.out.rfind(": "));
        EXPECT_EQ(sum, bare.substr(0, bare.rfind(": "))) << length;
    }
}

// a pipe that is filled in pieces, with moments in which it is empty
TEST(ListenIn, SaysTheSameAtAnyPace) {
    const ScratchFolder folder;
    const std::string at_once = hear(raw_with({"--json"}), folder, drive()).out;
    Pipe pipe(folder, raw_with({"--json", "--patience", "600 s"}));
    for (std::size_t k = 0; k < drive().size(); k += 9999) {
        pipe.write(drive().substr(k, 9999));
        // 12 s are there: a passage of 4 s at most is complete, and what comes after it is known
        if (k == 9999 * 39) {
            EXPECT_TRUE(tells(folder, "\"passage\""));
        }
    }
    pipe.close();
    EXPECT_EQ(pipe.process().wait().exit_code, 0);
    EXPECT_EQ(read_text(folder / "out.jsonl"), at_once);
}

TEST(ListenIn, KeepsClipsInAFolderAndInALibrary) {
    const ScratchFolder folder;
    const Finished finished = hear(raw_with({"--json", "--keep", "clips", "--library", "drive.sqlite", "--about",
                                             "system=seal", "--full-scale", "2 Pa"}),
                                   folder, drive());
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    const std::vector<json> noises = only(events_of(finished.out), "noise");
    ASSERT_FALSE(noises.empty());
    const json& clip = noises[0]["clip"];
    const double lead = noises[0]["from"].get<double>() - clip["from"].get<double>();
    EXPECT_NEAR(lead, std::min(2.0, noises[0]["from"].get<double>()), 1e-4);
    // the clip holds the bytes that came
    const std::string bytes = read_text(folder / clip["file"].get<std::string>());
    const auto first = 2 * static_cast<std::size_t>(std::llround(clip["from"].get<double>() * rate));
    const auto last = 2 * static_cast<std::size_t>(std::llround(clip["to"].get<double>() * rate));
    EXPECT_TRUE(bytes.ends_with(drive().substr(first, last - first)));
    const json entry = json_of(run({"library", "show", "1", "--library", "drive.sqlite", "--json"}, folder.path()).out);
    const json& kept = entry["entries"][0];
    EXPECT_EQ(kept["system"], "seal");
    EXPECT_EQ(kept["date"], "2026-11-27");
    EXPECT_EQ(kept["category"], "squeal");
    EXPECT_NE(kept["notes"].get<std::string>().find("2026-11-27T12:00:0"), std::string::npos) << kept["notes"];
}

TEST(ListenIn, EndsInOrderBySignals) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const ScratchFolder folder;
        Pipe pipe(folder, raw_with({"--json", "--keep", "clips", "--patience", "600 s"}));
        pipe.write(drive().substr(0, 2 * 12 * 16000));
        // the squeal is told, and its clip is not written yet: it may go on
        ASSERT_TRUE(tells(folder, "\"category\":\"squeal\""));
        pipe.process().send(signal);
        EXPECT_EQ(pipe.process().wait().exit_code, 0);
        const std::vector<json> events = events_of(read_text(folder / "out.jsonl"));
        EXPECT_EQ(events.back()["event"], "end");
        EXPECT_EQ(events.back()["why"], "stopped");
        EXPECT_EQ(events.back()["heard"], 12.0);  // what lay in the pipe, too
        ASSERT_EQ(only(events, "noise").size(), 1u);
        EXPECT_TRUE(std::filesystem::exists(folder / only(events, "noise")[0]["clip"]["file"].get<std::string>()));
        ASSERT_EQ(only(events, "take").size(), 1u);
    }
}

// what was told stands there, line by line, and no half of a clip
TEST(ListenIn, LosesOnlyWhatIsOpenWhenItIsKilled) {
    const ScratchFolder folder;
    Pipe pipe(folder, raw_with({"--json", "--keep", "clips", "--patience", "600 s"}));
    pipe.write(drive());
    ASSERT_TRUE(tells(folder, "\"category\":\"squeal\""));
    pipe.process().send(SIGKILL);
    EXPECT_EQ(pipe.process().wait().signal, SIGKILL);
    const std::string out = read_text(folder / "out.jsonl");
    EXPECT_TRUE(out.ends_with("\n"));
    EXPECT_FALSE(only(events_of(out), "passage").empty());
    for (const auto& file : std::filesystem::directory_iterator(folder / "clips"))
        EXPECT_EQ(file.path().filename().string().front(), '.') << file.path();
}

TEST(ListenIn, TellsThatNothingComesAndDoesNotBridgeIt) {
    const ScratchFolder folder;
    Pipe pipe(folder, raw_with({"--json", "--patience", "0.2 s"}));
    const std::size_t tear = 2 * 5 * 16000;  // in the squeal
    pipe.write(drive().substr(0, tear));
    ASSERT_TRUE(tells(folder, "\"at\":5.0,\"seconds\":null,\"why\":\"nothing came for 0.2 s\""));
    pipe.write(drive().substr(tear));
    pipe.close();
    EXPECT_EQ(pipe.process().wait().exit_code, 0);
    const std::vector<json> events = events_of(read_text(folder / "out.jsonl"));
    const std::vector<json> takes = only(events, "take");
    ASSERT_GE(takes.size(), 2u);
    // on a busy machine there may be more of them
    for (const json& take : takes) {
        const auto first = 2 * static_cast<std::size_t>(std::llround(take["from"].get<double>() * rate));
        const auto last = 2 * static_cast<std::size_t>(std::llround(take["to"].get<double>() * rate));
        EXPECT_EQ(take["classify"]["channels"][0]["verdict"],
                  verdict_of_file(folder, drive().substr(first, last - first)));
        EXPECT_TRUE(last <= tear || first >= tear);
    }
    EXPECT_EQ(events.back()["heard"], 14.0);
}

TEST(ListenIn, TellsWhatWasCut) {
    const ScratchFolder folder;
    const std::string whole = wav(drive());
    const std::vector<json> cut =
        events_of(hear({"listen-in", "--json"}, folder, whole.substr(0, whole.size() / 2)).out);
    ASSERT_EQ(only(cut, "gap").size(), 1u);
    EXPECT_NE(only(cut, "gap")[0]["why"].get<std::string>().find("it was cut"), std::string::npos);
    const std::vector<json> odd = events_of(hear(raw_with({"--json"}), folder, drive() + "x").out);
    ASSERT_EQ(only(odd, "gap").size(), 1u);
    EXPECT_NE(only(odd, "gap")[0]["why"].get<std::string>().find("1 byte of a frame of 2"), std::string::npos);
    // what stands behind the samples is no sound
    const std::vector<json> more =
        events_of(hear({"listen-in", "--json"}, folder, whole + "LIST" + bytes_of(4, 4) + "INFO").out);
    EXPECT_TRUE(only(more, "gap").empty());
    EXPECT_EQ(more.back()["heard"], 14.0);
}

TEST(ListenIn, FollowsAFileThatIsBeingWritten) {
    const ScratchFolder folder;
    const json expected = verdict_of_file(folder, drive());
    {
        std::ofstream file(folder / "growing.wav", std::ios::binary);
        file << wav_head(0) << drive().substr(0, 100'001);
    }
    Process process(
        Launch{{"-c", "exec \"$0\" listen-in --follow growing.wav --json --patience '60 s' > out.jsonl", program()},
               folder.path(),
               {},
               std::nullopt,
               {},
               "/bin/sh"});
    ASSERT_TRUE(tells(folder, "\"begin\""));
    {
        std::ofstream file(folder / "growing.wav", std::ios::binary | std::ios::app);
        file << drive().substr(100'001);
    }
    std::filesystem::remove(folder / "growing.wav");  // what was written is heard nevertheless
    EXPECT_EQ(process.wait().exit_code, 0);
    const std::vector<json> events = events_of(read_text(folder / "out.jsonl"));
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back()["why"], "the file was removed");
    EXPECT_EQ(events.back()["gaps"], 1) << "what else was written nobody knows";
    EXPECT_EQ(only(events, "gap").size(), 1u);
    ASSERT_EQ(only(events, "take").size(), 1u);
    EXPECT_EQ(only(events, "take")[0]["classify"]["channels"][0]["verdict"], expected);
}

// the length stands in its head, and other chunks behind its samples
TEST(ListenIn, EndsWithAFileThatIsWhole) {
    const ScratchFolder folder;
    const json expected = verdict_of_file(folder, drive());
    write_text(folder / "tagged.wav", wav(drive()) + "LIST" + bytes_of(400'000, 4) + std::string(400'000, 'x'));
    for (const char* file : {"whole.wav", "tagged.wav"}) {
        const std::vector<json> events =
            events_of(run({"listen-in", "--follow", file, "--json", "--patience", "0.1 s"}, folder.path()).out);
        ASSERT_FALSE(events.empty());
        EXPECT_EQ(events.back()["why"], "the file is whole") << file;
        EXPECT_EQ(events.back()["gaps"], 0) << file;
        EXPECT_EQ(only(events, "take")[0]["classify"]["channels"][0]["verdict"], expected) << file;
    }
}

TEST(ListenIn, RecordsFromADeviceAndTellsWhatItLost) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "bin");
    write_text(folder / "sound.raw", drive());
    write_text(folder / "bin/arecord",
               "#!/bin/sh\necho \"$@\" > arguments\nhead -c 160000 sound.raw\nsleep 1\n"
               "echo 'overrun!!! (at least 12.500 ms long)' >&2\nsleep 1\ntail -c +160001 sound.raw\n");
    std::filesystem::permissions(folder / "bin/arecord", std::filesystem::perms::owner_all);
    const std::string path = (folder / "bin").string() + ":/usr/bin:/bin";
    const Finished finished = run(Launch{{"listen-in", "--device", "hw:1,0", "--rate", "16000", "--json"},
                                         folder.path(),
                                         {},
                                         std::nullopt,
                                         {{"PATH", path}}});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    const std::vector<json> events = events_of(finished.out);
    ASSERT_EQ(only(events, "gap").size(), 1u);
    EXPECT_NEAR(only(events, "gap")[0]["seconds"].get<double>(), 0.0125, 1e-9);
    EXPECT_EQ(only(events, "gap")[0]["at"], 5.0);
    EXPECT_EQ(only(events, "take").size(), 2u);
    EXPECT_NE(read_text(folder / "arguments").find("--device=hw:1,0"), std::string::npos);
}

TEST(ListenIn, SaysWhatARecorderSaidWhenItFailed) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "bin");
    write_text(folder / "bin/arecord", "#!/bin/sh\necho 'audio open error: No such device' >&2\nexit 1\n");
    std::filesystem::permissions(folder / "bin/arecord", std::filesystem::perms::owner_all);
    const std::string path = (folder / "bin").string() + ":/usr/bin:/bin";
    const Launch failing{{"listen-in", "--device", "hw:9,0"}, folder.path(), {}, std::nullopt, {{"PATH", path}}};
    expect_refused(run(failing), 5, "No such device");
    const Launch none{{"listen-in", "--device", "hw:9,0"}, folder.path(), {}, std::nullopt, {{"PATH", "/nowhere"}}};
    expect_refused(run(none), 5, "alsa-utils");
}

TEST(ListenIn, GoesOnWhereTheDiskIsFull) {
    const ScratchFolder folder;
    const Finished finished = hear(raw_with({"--keep", "clips"}), folder, drive(), 20'000UL);
    expect_refused(finished, 5, "clips could not be kept");
    EXPECT_NE(finished.out.find("not kept: "), std::string::npos) << finished.out;
    EXPECT_NE(finished.out.find("heard 14.000 s in 1 take, 1 noise, 0 gaps"), std::string::npos) << finished.out;
}

TEST(ListenIn, RefusesWhatCannotBeHeard) {
    const ScratchFolder folder;
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& input,
                             const std::string& words) { expect_refused(hear(arguments, folder, input), 2, words); };
    refused({"listen-in"}, drive(), "--raw s16le");
    refused({"listen-in"}, "", "ended before its first sample");
    refused({"listen-in"}, wav_head(0).substr(0, 30), "its head is not whole");
    refused(raw, wav(drive()), "Leave out --raw");
    refused({"listen-in", "--raw", "s16"}, drive(), "s16le");
    refused({"listen-in", "--raw", "s16le", "--rate", "500"}, drive(), "rate of 500 Hz");
    refused(raw_with({"--channel", "2"}), drive(), "channel");
    refused(raw_with({"--full-scale", "2 Pa", "--full-scale", "3 Pa"}), drive(), "2 full scales for 1 channel");
    refused(raw_with({"--patience", "0 s"}), drive(), "too short");
    refused({"listen-in", "--raw", "s16le", "--rate", "16000", "--began", "noon"}, drive(), "2026-11-27T15:42:25Z");
    refused(raw_with({"--about", "sytem=seal"}), drive(), "Did you mean \"system\"?");
    refused(raw_with({"--about", "seal"}), drive(), "FIELD=VALUE is needed");
    // before the first sample, of which there is none
    refused({"listen-in", "--set", "certainly=0.6"}, "", "certainty");
    refused({"listen-in", "--about", "sytem=seal"}, "", "Did you mean \"system\"?");
    refused({"listen-in", "door.wav"}, "", "--follow");
    refused({"listen-in", "--raw", "f32le", "--rate", "16000"},
            std::string("\0\0\xc0\x7f", 4) + std::string(9996, '\0'), "sample 1");
}
