#include "program/library_program.hpp"
#include "support/json_of.hpp"
#include "support/wait.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

using stridor::noise_library::Library;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::LibraryProgram;
using stridor::support::Process;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::wait_until;
using stridor::support::wav;
using stridor::support::with_file;
using stridor::support::write_text;

TEST_F(LibraryProgram, KeepsTheLibraryInTheUsersDataFolder) {
    write_text(folder_ / "a.wav", wav(1));
    expect_done({"library", "add", "a.wav", "--system", "brake", "--preload", "0.04 kN", "--temperature", "-10 degC"});
    EXPECT_TRUE(std::filesystem::exists(folder_ / "data/stridor/library.sqlite"));
    const auto document = json_of(stridor({"library", "list", "--json"}).out);
    const auto& entry = document["entries"][0];
    EXPECT_EQ(entry["preload"], 40.0);
    EXPECT_EQ(entry["temperature"], -10.0);
    EXPECT_EQ(entry["duration"], 0.1);
    EXPECT_EQ(entry["rate"], 8000.0);
    const std::string audio = stridor({"library", "show", "1", "--audio"}).out;
    EXPECT_EQ(read_text(audio.substr(0, audio.size() - 1)), wav(1));
}

TEST_F(LibraryProgram, RefusesWhatItDoesNotKnow) {
    write_text(folder_ / "a.wav", wav(1));
    write_text(folder_ / "text.wav", "RIFF no sound");
    write_text(folder_ / "empty.wav", wav(1, 0));
    expect_refused(with_file({"library", "list"}), 5, {"there is no library", "library add"});
    expect_done(with_file({"library", "add", "a.wav"}));
    expect_refused(with_file({"library", "add", "text.wav"}), 2, {"text.wav"});
    expect_refused(with_file({"library", "add", "empty.wav"}), 2, {"empty.wav"});
    expect_refused(with_file({"library", "add", "nowhere.wav"}), 5, {"nowhere.wav"});
    expect_refused(with_file({"library", "add", "a.wav", "--preload", "3 mm"}), 2, {"preload", "length", "force"});
    expect_refused(with_file({"library", "add", "a.wav", "--recorded", "vehicel"}), 2, {"vehicle"});
    expect_refused(with_file({"library", "show", "7"}), 2, {"no entry 7"});
    expect_refused(with_file({"library", "edit", "1"}), 2, {"nothing to change"});
    expect_refused(with_file({"library", "list", "--where", "prelaod > 3"}), 2, {"prelaod", "preload"});
    expect_refused(with_file({"library", "list", "--columns", "id,sistem"}), 2, {"sistem", "system"});
    expect_refused(with_file({"library", "import", "a.wav"}), 2, {"a.wav"});
    expect_refused(with_file({"rig", "sensitivity", "--over", "notes"}), 2, {"notes"});
    expect_refused(with_file({"rig", "sensitivity"}), 2, {"no records over preload"});
    expect_refused({"library", "list", "--library", "a.wav"}, 2, {"no library"});
    EXPECT_EQ(broken_promise(), "");
}

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(LibraryProgram, AddsAFolderPastWhatIsKnownAndWhatIsBroken) {
    std::filesystem::create_directories(folder_ / "runs/monday/lab.audio");
    write_text(folder_ / "runs/first.wav", wav(1));
    write_text(folder_ / "runs/monday/again.WAV", wav(1));
    write_text(folder_ / "runs/monday/second.wav", wav(2));
    write_text(folder_ / "runs/monday/second.wav.json", R"({"schema": "stridor.sidecar/1"})");
    write_text(folder_ / "runs/monday/lab.audio/third.wav", wav(3));  // a library's own folder, but of another one
    write_text(folder_ / "runs/monday/notes.md", "loud");
    write_text(folder_ / "runs/._first.wav", "what another system leaves beside a file");
    write_text(folder_ / "runs/text.wav", "RIFF no sound");
    write_text(folder_ / "runs/void.flac", "");
    std::filesystem::create_symlink("..", folder_ / "runs/monday/up");
    const std::vector<std::string> add =
        with_file({"library", "add", "runs", "runs/monday/second.wav.json", "--system", "seal"});
    const Finished first = stridor(add);
    EXPECT_EQ(first.exit_code, 2);
    EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 3) << first.out;
    EXPECT_TRUE(has(first.err, "added 3, known 1, refused 2; passed over 1 that")) << first.err;
    EXPECT_TRUE(has(first.err, "known    runs/monday/again.WAV: entry 1 ")) << first.err;
    EXPECT_TRUE(has(first.err, "refused  runs/text.wav: ")) << first.err;
    EXPECT_TRUE(has(first.err, "refused  runs/void.flac: the file is empty")) << first.err;
    EXPECT_TRUE(has(first.err, "refused 2 of 6 recordings")) << first.err;

    std::vector<std::string> as_json = add;
    as_json.emplace_back("--json");
    const Finished second = stridor(as_json);
    EXPECT_EQ(second.exit_code, 2);
    const auto summary = json_of(second.out)["summary"];
    EXPECT_EQ(summary["added"].size(), 0U);
    EXPECT_EQ(summary["known"].size(), 4U);
    EXPECT_EQ(summary["known"][0]["id"], 1);
    EXPECT_EQ(summary["refused"][1]["file"], "runs/void.flac");
    EXPECT_EQ(summary["passed_over"], 1);
    EXPECT_EQ(summary["left"], 0);
    EXPECT_EQ(broken_promise(), "");
}

TEST_F(LibraryProgram, LeavesOutItsOwnAudioAndAddsNothingTwice) {
    write_text(folder_ / "a.wav", wav(1));
    expect_done(with_file({"library", "add", "."}));
    const Finished again = stridor(with_file({"library", "add", "."}));
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_TRUE(has(again.err, "added 0, known 1, refused 0")) << again.err;
    // a file by itself, too
    const Finished alone = stridor(with_file({"library", "add", "a.wav"}));
    EXPECT_EQ(alone.exit_code, 0);
    EXPECT_TRUE(has(alone.err, "known    a.wav: entry 1 ")) << alone.err;
    EXPECT_EQ(alone.out, "");
    expect_done(with_file({"library", "add", "a.wav", "--again"}));
    EXPECT_EQ(Library(folder_ / "library.sqlite").size(), 2);
}

TEST_F(LibraryProgram, BeginsWithNoisesOfManySystemsOfEveryCategory) {
    const auto made = json_of(stridor({"library", "starter", "try.sqlite", "--json"}).out);
    EXPECT_GE(made["summary"]["added"].size(), 40U);
    std::map<std::string, int> categories;
    std::map<double, double> seals;  // [N], [dB]
    for (const auto& entry : made["entries"]) {
        ++categories[entry["category"]];
        EXPECT_EQ(entry["recorded"], "simulation");
        EXPECT_NE(entry["case"].get<std::string>().find("[contact]"), std::string::npos);
        if (entry["system"] == "seal") seals[entry["preload"]] = entry["figures"]["level"];
    }
    for (const char* category : {"none", "squeal", "squeak", "creak"})
        EXPECT_GE(categories[category], 5) << category;
    EXPECT_GT(seals.rbegin()->second, seals.begin()->second + 20.0);
    EXPECT_EQ(broken_promise("try.sqlite"), "");

    // the same noises again: nothing new, and nothing made
    const Finished again = stridor({"library", "starter", "--library", "try.sqlite"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.out, "");
    EXPECT_TRUE(has(again.err, "added 0, known " + std::to_string(made["summary"]["added"].size()))) << again.err;
    // the samples do not depend on the machine
    const std::string audio = stridor({"library", "show", "1", "--audio", "--library", "try.sqlite"}).out;
    const std::string wave = read_text(folder_ / audio.substr(0, audio.size() - 1));
    EXPECT_EQ(stridor::base::sha256_text(wave.substr(wave.find("data"))),
              "03f434a4adc2c6f5de3089f38b4b8f868dcbceed071b921e16622a781306d927");
}

TEST_F(LibraryProgram, StopsBetweenFilesAndGoesOnFromThere) {
    constexpr int files = 100;
    std::filesystem::create_directory(folder_ / "runs");
    for (int k = 0; k < files; ++k)
        write_text(folder_ / ("runs/" + std::to_string(100 + k) + ".wav"), wav(static_cast<std::uint64_t>(k), 50000));
    const std::vector<std::string> add = with_file({"library", "add", "runs", "--json"});
    Process process(Launch{add, folder_.path(), {}, std::nullopt, {}});
    ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(folder_ / "library.audio"); }));
    process.send(SIGINT);
    const Finished stopped = process.wait();
    EXPECT_EQ(stopped.exit_code, 4) << stopped.err;
    EXPECT_TRUE(has(stopped.err, "The same command again goes on")) << stopped.err;
    const auto first = json_of(stopped.out)["summary"];
    EXPECT_EQ(broken_promise(), "");
    EXPECT_EQ(Library(folder_ / "library.sqlite").size(), static_cast<std::int64_t>(first["added"].size()));
    EXPECT_EQ(first["added"].size() + first["left"].get<std::size_t>(), static_cast<std::size_t>(files));
    EXPECT_GT(first["left"].get<int>(), 0);

    const Finished rest = stridor(add);
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    const auto second = json_of(rest.out)["summary"];
    EXPECT_EQ(second["known"].size(), first["added"].size());
    EXPECT_EQ(second["added"].size(), first["left"].get<std::size_t>());
}

TEST_F(LibraryProgram, DrawsAndPrintsASensitivity) {
    for (int k = 1; k <= 5; ++k) {
        write_text(folder_ / "a.wav", wav(static_cast<std::uint64_t>(k)));
        expect_done(with_file({"library", "add", "a.wav", "--preload", std::to_string(10 * k), "--denomination",
                               k < 3 ? "squeal" : "creak", "--figure", "level=" + std::to_string(60 - k) + " dB"}));
    }
    const Finished table = stridor(
        with_file({"rig", "sensitivity", "--by", "denomination", "--figure", "s.png", "--where", "preload < 45 N"}));
    EXPECT_EQ(table.exit_code, 0) << table.err;
    // 2 of the 24 ways to pair four records
    EXPECT_NE(table.out.find("level                rank correlation -1.000 (Spearman, n = 4, p = 0.083)"),
              std::string::npos)
        << table.out;
    EXPECT_NE(table.out.find("squeal       2 records, preload 10 to 20 N"), std::string::npos) << table.out;
    EXPECT_TRUE(read_text(folder_ / "s.png").starts_with("\x89PNG"));
    const auto document = json_of(stridor(with_file({"rig", "sensitivity", "--json"})).out);
    EXPECT_EQ(document["level"]["spearman"], -1.0);
}

namespace {

// a rig's run of two seconds: a force that sticks and slips between 8 and 6 N, the drive, and a tone of 740 Hz
std::string rig_run(const std::string& comments) {
    std::string text = comments + "time,friction force,imposed velocity,sound\ns,N,m/s,Pa\n";
    for (int k = 0; k < 8000; ++k) {
        const double time = k / 4000.0;
        text += std::to_string(time) + "," + std::to_string(6.0 + 0.01 * (k % 200)) + ",0.004," +
                std::to_string(0.1 * std::sin(2.0 * std::numbers::pi * 740.0 * time)) + "\n";
    }
    return text;
}

}  // namespace

TEST_F(LibraryProgram, ListensToWhatASimulationSoundsLikeAndKnowsItForOne) {
    for (const std::string kind : {"squeal", "creak"}) {
        write_text(folder_ / (kind + ".toml"), stridor({"init", kind}).out);
        expect_done({"listen", kind + ".toml", "--out", kind + ".wav", "--seconds", "0.6"});
    }
    expect_refused(with_file({"library", "add", "squeal.wav", "--recorded", "vehicle"}), 2, {"simulated", "vehicle"});
    const Finished added = stridor(with_file({"library", "add", "squeal.wav", "creak.wav", "--system", "seal"}));
    EXPECT_NE(added.out.find("1 channel: squeal\n"), std::string::npos) << added.out;
    EXPECT_NE(added.err.find("squeal.wav is a simulation; its case says preload 20 N"), std::string::npos) << added.err;

    const auto document = json_of(stridor(with_file({"library", "list", "--json"})).out);
    const auto& squeal = document["entries"][0];
    EXPECT_EQ(squeal["recorded"], "simulation");
    EXPECT_EQ(squeal["category"], "squeal");
    EXPECT_EQ(squeal["preload"], 20.0);
    // peak of 4 mm at 5 Hz
    EXPECT_NEAR(squeal["velocity"].get<double>(), 2.0 * std::numbers::pi * 5.0 * 0.004, 1e-6);
    EXPECT_EQ(squeal["verdict"]["schema"], "stridor.verdict/1");
    EXPECT_EQ(document["units"]["figures.level"], "dB re 1e-9 m/s");
    EXPECT_GT(squeal["figures"]["regularity"].get<double>(), 0.8);
    // the case came along, and makes the same sound again
    write_text(folder_ / "again.toml", stridor(with_file({"library", "show", "1", "--field", "case"})).out);
    expect_done({"listen", "again.toml", "--out", "again.wav", "--seconds", "0.6"});
    EXPECT_EQ(read_text(folder_ / "again.wav").substr(1000), read_text(folder_ / "squeal.wav").substr(1000));

    const auto moved = json_of(stridor(with_file({"rig", "sensitivity", "--json"})).out);
    EXPECT_EQ(moved["records"][0]["category"], "squeal");
    EXPECT_EQ(moved["records"][1]["category"], "creak");
    EXPECT_EQ(moved["records"][1]["preload"], 2000.0);
    EXPECT_EQ(broken_promise(), "");
}

TEST_F(LibraryProgram, ReadsFromARunWhatTheUserDidNotSay) {
    write_text(folder_ / "run.csv",
               rig_run("# Normal load [N]: 20\n# temperature: 23 °C\n# rh: 50 %\n# speed: slow\n"));
    const Finished added =
        stridor(with_file({"library", "add", "run.csv", "--recorded", "rig", "--temperature", "25", "--json"}));
    ASSERT_EQ(added.exit_code, 0) << added.err;
    EXPECT_NE(added.err.find("run.csv says preload 20 N, humidity 50 %"), std::string::npos) << added.err;
    EXPECT_NE(added.err.find("velocity is \"slow\""), std::string::npos) << added.err;
    const auto entry = json_of(added.out)["entries"][0];
    EXPECT_EQ(entry["preload"], 20.0);
    EXPECT_EQ(entry["temperature"], 25.0);
    EXPECT_EQ(entry["humidity"], 50.0);
    EXPECT_EQ(entry["velocity"], 0.004);
    EXPECT_EQ(entry["verdict"]["channel"], 3);
    EXPECT_EQ(entry["category"], "squeal");
    const auto& figures = entry["figures"];
    EXPECT_NEAR(figures["dominant_frequency"].get<double>(), 740.0, 1.0);
    // a sine of 0.1 Pa: 70.97 dB
    EXPECT_NEAR(figures["level"].get<double>(), 70.97, 0.1);
    // the force lets go at 7.99 N of 20 N, and comes back to 6 N
    EXPECT_NEAR(figures["static_friction"].get<double>(), 0.4, 0.001);
    EXPECT_NEAR(figures["kinetic_friction"].get<double>(), 0.35, 0.002);
    EXPECT_NEAR(figures["drop_rate"].get<double>(), 20.0, 1.0);

    expect_done(with_file({"library", "add", "run.csv", "--no-verdict", "--again"}));
    const auto silent = json_of(stridor(with_file({"library", "show", "2", "--json"})).out)["entries"][0];
    EXPECT_FALSE(silent.contains("category"));
    EXPECT_FALSE(silent["figures"].contains("level"));
}

TEST_F(LibraryProgram, JudgesAgainWhatHasNoVerdictAndKeepsTheUsersFigures) {
    write_text(folder_ / "run.csv", rig_run(""));
    const Finished added = stridor(with_file({"library", "add", "run.csv", "--no-verdict", "--figure", "kurtosis=3"}));
    EXPECT_EQ(added.exit_code, 0) << added.err;
    EXPECT_EQ(added.out.find("nan"), std::string::npos) << added.out;
    EXPECT_EQ(stridor(with_file({"library", "judge"})).out, "   1  run.csv  squeal\n");
    EXPECT_NE(stridor(with_file({"library", "judge"})).err.find("nothing to judge"), std::string::npos);
    expect_done(with_file({"library", "edit", "1", "--figure", "level=60 dB"}));
    expect_done(with_file({"library", "judge", "1"}));
    const auto entry = json_of(stridor(with_file({"library", "show", "1", "--json"})).out)["entries"][0];
    EXPECT_EQ(entry["figures"]["kurtosis"], 3.0);
    EXPECT_EQ(entry["figures"]["level"], 60.0);
    EXPECT_NEAR(entry["figures"]["dominant_frequency"].get<double>(), 740.0, 1.0);
    expect_refused(with_file({"library", "judge", "1", "--channel", "sond"}), 2, {"no channel", "sound"});
    expect_refused(with_file({"library", "judge", "7"}), 2, {"no entry 7"});
}
