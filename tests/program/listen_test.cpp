// Listening and the rig from outside.

#include "support/effort.hpp"
#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <span>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

const ScratchFolder& folder() {
    static const ScratchFolder shared;
    static const bool is_filled = [] {
        write_text(shared / "squeal.toml", run({"init", "squeal"}).out);
        write_text(shared / "pair.toml", run({"init", "noise-chart"}).out);
        return true;
    }();
    (void)is_filled;
    return shared;
}

json listened(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "listen");
    arguments.insert(arguments.end(), {"--json"});
    const Finished finished = run(arguments, folder().path());
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json_of(finished.out);
}

json file_facts(const std::string& name) {
    const Finished finished = run({"convert", name, "--json"}, folder().path());
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json_of(finished.out);
}

}  // namespace

TEST(Listen, WritesASoundWhoseFullScaleIsAVelocity) {
    constexpr std::array rates{44100, 51200, 48000};
    for (const int rate : std::span(rates).first(stridor::support::effort(3U, 1U))) {
        const json document =
            listened({"squeal.toml", "--out", "a.wav", "--rate", std::to_string(rate), "--seconds", "0.3"});
        EXPECT_EQ(document["schema"], "stridor.listen/1");
        const json& sound = document["sound"];
        EXPECT_EQ(sound["rate"], rate);
        EXPECT_NEAR(sound["duration"].get<double>(), 0.3, 1.5 / rate);
        EXPECT_EQ(document["units"]["sound.peak"], "m/s");
        // -1 dBFS
        EXPECT_NEAR(sound["peak"].get<double>() / sound["full_scale"].get<double>(), std::pow(10.0, -0.05), 1e-12);
        const std::string facts = file_facts("a.wav").dump();
        EXPECT_NE(facts.find("m/s"), std::string::npos) << facts;
        EXPECT_EQ(facts.find("\"Pa\""), std::string::npos);
    }
}

TEST(Listen, CutsADirectionAndSimulatesLonger) {
    EXPECT_NEAR(listened({"squeal.toml", "--out", "a.wav", "--direction", "going"})["sound"]["duration"].get<double>(),
                0.5, 1e-3);
    EXPECT_NEAR(listened({"squeal.toml", "--out", "a.wav", "--seconds", "1.5"})["sound"]["duration"].get<double>(), 1.5,
                1e-3);
    const json judged = listened({"squeal.toml", "--out", "a.wav", "--direction", "going", "--judged"});
    EXPECT_NEAR(judged["sound"]["duration"].get<double>(), 4 * 0.04, 1e-3);
}

TEST(Listen, GivesACellOfAChart) {
    const json document =
        listened({"pair.toml", "--cell", "x=20 N,y=0.6", "--direction", "going", "--out", "a.wav", "--seconds", "0.2"});
    EXPECT_NEAR(document["case"]["contact"]["preload"].get<double>(), 20.0, 3.0);
    EXPECT_NEAR(document["case"]["contact"]["kinetic_friction"].get<double>(), 0.6, 0.02);
    EXPECT_GT(document["case"]["drive"]["velocity"].get<double>(), 0.0);
    const json coming = listened(
        {"pair.toml", "--cell", "x=20 N,y=0.6", "--direction", "coming", "--out", "a.wav", "--seconds", "0.2"});
    EXPECT_LT(coming["case"]["drive"]["velocity"].get<double>(), 0.0);
}

TEST(Listen, HearsTheBeta2EngineToo) {
    const auto peak = [](const json& document) { return document["sound"]["peak"].get<double>(); };
    const json exact = listened({"squeal.toml", "--out", "a.wav", "--seconds", "0.1"});
    const json stepped = listened({"squeal.toml", "--out", "b.wav", "--seconds", "0.1", "--set", "run.engine=beta_2",
                                   "--set", "run.step=1e-6", "--set", "run.duration=0.3", "--set", "run.window=0.3"});
    EXPECT_NEAR(peak(stepped) / peak(exact), 1.0, 0.1);
}

TEST(Listen, HearsTheStringAtItsOwnPitch) {
    write_text(folder() / "string.toml", run({"init", "string"}).out);
    const std::string duration = "run.duration=1", window = "run.window=0.5";
    const json document = listened({"string.toml", "--out", "string.wav", "--set", duration, "--set", window});
    EXPECT_EQ(document["sound"]["of"], "bow");
    const Finished heard = run({"analyse", "string.wav", "--json"}, folder().path());
    ASSERT_EQ(heard.exit_code, 0) << heard.err;
    const json frequency = json_of(heard.out)["channels"][0]["spectrum"]["peaks"][0]["frequency"];
    const json phase =
        json_of(run({"simulate", "string.toml", "--json", "--set", duration, "--set", window}, folder().path())
                    .out)["phases"][0];
    // the interpolated peak of a line 17.6 Hz wide: 0.1 Hz off is what a hundredth of its width makes
    EXPECT_NEAR(frequency.get<double>(), phase["verdict"]["frequency"].get<double>(), 1.0);
}

// a player is given a file by name: it goes with the player, and after a kill with the next one
TEST(Listen, LeavesNoSoundBehindOncePlayed) {
    const ScratchFolder folder(stridor::support::Medium::disk);
    std::filesystem::create_directories(folder / "tmp");
    write_text(folder / "squeal.toml", run({"init", "squeal"}).out);
    const auto play = [&](const std::string& player) {
        write_text(folder / "aplay", "#!/bin/sh\n" + player + "\n");
        std::filesystem::permissions(folder / "aplay", std::filesystem::perms::owner_all);
        return run(Launch{{"listen", "squeal.toml", "--seconds", "0.3"},
                          folder.path(),
                          {},
                          std::nullopt,
                          {{"PATH", folder.path()}, {"TMPDIR", folder / "tmp"}}});
    };
    const Finished played = play("test -s \"$2\" || exit 3");
    EXPECT_EQ(played.exit_code, 0) << played.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder / "tmp"));
    EXPECT_EQ(play("kill -9 $PPID").signal, SIGKILL);
    EXPECT_FALSE(std::filesystem::is_empty(folder / "tmp"));
    EXPECT_EQ(play("exit 0").exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "tmp"));
}

TEST(Listen, RefusesWhatCannotBeHeard) {
    const std::vector<std::vector<std::string>> wrong{
        {"--out", "a.mp3"},
        {"--of", "plate", "--component", "x"},
        {"--rate", "44.1"},
        {"--seconds", "0"},
        {"--cell", "x=20"},
        {"--level", "absolute", "--full-scale", "1 mm/s"},
        {"--level", "absolute", "--full-scale", "1 Pa"},
        {"--full-scale", "1 m/s"},
        {"--judged"},
        {"--high-pass", "20 kHz"},
        {"--fade", "-1 s"},
        {"--set", "run.engine=beta_2", "--set", "run.step=1e-5"},
    };
    for (const std::vector<std::string>& more : wrong) {
        std::vector<std::string> arguments{"listen", "squeal.toml", "--out", "x.wav"};
        if (more[0] == "--out") arguments.resize(2);
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished finished = run(arguments, folder().path());
        EXPECT_EQ(finished.exit_code, 2) << more[0] << finished.err;
        EXPECT_NE(finished.err.find("error:"), std::string::npos);
    }
}

namespace {

// T of a body dragged at 4 mm/s: climbs from 2 N to 4 N in 0.25 s, slides for 10 ms at 3 N
std::string dragged() {
    std::string text = "time,friction\ns,N\n";
    for (int k = 0; k < 2600; ++k) {
        const int phase = k % 260;
        const double force = phase < 250 ? 2.0 + 2.0 * phase / 249.0 : 3.0;
        text += std::to_string(k) + "e-3," + std::to_string(force) + "\n";
    }
    return text;
}

}  // namespace

TEST(RigFriction, ReadsCoefficientsAndDrops) {
    write_text(folder() / "dragged.csv", dragged());
    const Finished finished =
        run({"rig", "friction", "dragged.csv", "--preload", "10 N", "--velocity", "4 mm/s", "--json"}, folder().path());
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    const json document = json_of(finished.out);
    EXPECT_EQ(document["schema"], "stridor.friction/1");
    EXPECT_EQ(document["test"]["condition"], "VDA 230-206, 10 N, 4 mm/s");
    EXPECT_EQ(document["all"]["drops"], 9);  // the tenth is followed by no rise
    EXPECT_EQ(document["drops"].size(), 9U);
    EXPECT_NEAR(document["all"]["static_friction"]["value"].get<double>(), 0.4, 0.001);
    EXPECT_NEAR(document["all"]["kinetic_friction"]["value"].get<double>(), 0.3, 1e-6);
}

TEST(RigFriction, PutsTheCoefficientsIntoACase) {
    write_text(folder() / "dragged.csv", dragged());
    const Finished finished =
        run({"rig", "friction", "dragged.csv", "--preload", "10 N", "--into", "squeal.toml"}, folder().path());
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    write_text(folder() / "measured.toml", finished.out);
    const Finished checked = run({"check", "measured.toml", "--json"}, folder().path());
    ASSERT_EQ(checked.exit_code, 0) << checked.err;
    const json contact = json_of(checked.out)["contact"];
    EXPECT_NEAR(contact["static_friction"].get<double>(), 0.4, 0.001);
    EXPECT_NEAR(contact["kinetic_friction"].get<double>(), 0.3, 1e-4);
    EXPECT_EQ(contact["preload"], 20.0);  // the case's own
}

TEST(RigFriction, PutsTheCoefficientsIntoEachContactOfAStructure) {
    write_text(folder() / "dragged.csv", dragged());
    const std::string own =
        "[structure]\nmass = [[1, 0], [0, 1]]\nstiffness = [[9, 0], [0, 9]]\n[[structure.contact]]\nname = \"tip\"\n"
        "normal = \"u2\"\ntangent = \"u1\"\nstatic_friction = 0.9\nkinetic_friction = 0.8\n"
        "[contact]\npreload = 5\n[drive]\nkind = \"constant\"\nvelocity = 0.1\n[run]\nduration = 9\n";
    write_text(folder() / "own.toml", own);
    const Finished finished =
        run({"rig", "friction", "dragged.csv", "--preload", "10 N", "--into", "own.toml"}, folder().path());
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    write_text(folder() / "own_measured.toml", finished.out);
    const Finished checked = run({"check", "own_measured.toml", "--json"}, folder().path());
    ASSERT_EQ(checked.exit_code, 0) << checked.err;
    const json tip = json_of(checked.out)["structure"]["contacts"][0];
    EXPECT_NEAR(tip["static_friction"].get<double>(), 0.4, 0.001);
    EXPECT_NEAR(tip["kinetic_friction"].get<double>(), 0.3, 1e-4);
}

TEST(RigFriction, RefusesWhatIsNoFrictionForce) {
    write_text(folder() / "dragged.csv", dragged());
    write_text(folder() / "two.csv", "time,a,b\ns,N,N\n0,1,2\n0.1,1,2\n0.2,1,2\n");
    write_text(folder() / "sound.csv", "time,a\ns,Pa\n0,1\n0.1,1\n0.2,1\n");
    const std::vector<std::vector<std::string>> wrong{
        {"dragged.csv"},
        {"dragged.csv", "--preload", "-1"},
        {"dragged.csv", "--preload", "10 mm"},
        {"dragged.csv", "--preload", "10", "--channel", "torque"},
        {"dragged.csv", "--preload", "10", "--into", "missing.toml"},
        {"two.csv", "--preload", "10"},
        {"sound.csv", "--preload", "10"},
    };
    for (const std::vector<std::string>& more : wrong) {
        std::vector<std::string> arguments{"rig", "friction"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished finished = run(arguments, folder().path());
        EXPECT_TRUE(finished.exit_code == 2 || finished.exit_code == 5) << finished.exit_code << finished.err;
        EXPECT_TRUE(finished.out.empty());
    }
}
