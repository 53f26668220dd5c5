#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::wait_until;
using stridor::support::write_text;

namespace {

class Advise : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "squeal.toml", run({"init", "squeal"}).out); }

    Finished advise(std::vector<std::string> more) const {
        more.insert(more.begin(), {"advise", "squeal.toml"});
        return run(more, folder_.path());
    }

    json document(std::vector<std::string> more) const {
        more.emplace_back("--json");
        const Finished finished = advise(more);
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
        return json_of(finished.out);
    }

    void expect_refused(const std::vector<std::string>& more, const std::vector<std::string>& words) const {
        const Finished finished = advise(more);
        EXPECT_EQ(finished.exit_code, 2) << finished.err;
        EXPECT_EQ(finished.out, "");
        for (const std::string& word : words)
            EXPECT_NE(finished.err.find(word), std::string::npos) << "\"" << word << "\" is not in:\n" << finished.err;
    }

    ScratchFolder folder_;
};

const std::vector<std::string> friction{"--over", "kinetic_friction=0.3:0.8"};

}  // namespace

TEST_F(Advise, SaysHowFarItIsALinePerTenPercent) {
    const Finished finished = advise({"--over", "kinetic_friction", "--over", "preload=5:50"});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    int lines = 0;
    int last = 0;
    for (std::size_t at = 0; (at = finished.err.find("advice: ", at)) != std::string::npos; ++at) {
        const int percent = std::stoi(finished.err.substr(at + 8));
        EXPECT_GT(percent, last) << "it never goes back:\n" << finished.err;
        last = percent;
        ++lines;
    }
    EXPECT_GE(lines, 3) << finished.err;
    EXPECT_LE(lines, 10) << finished.err;
    EXPECT_NE(finished.err.find(" of 4: "), std::string::npos) << finished.err;
    EXPECT_NE(finished.err.find(" left"), std::string::npos) << finished.err;
}

TEST_F(Advise, NamesAChangeThatSimulateCallsQuiet) {
    const json advice = document(friction);
    EXPECT_EQ(advice["schema"], "stridor.advice/1");
    EXPECT_EQ(advice["present"]["phases"]["going"], "squeal");
    std::vector<std::string> arguments{"simulate", "squeal.toml", "--json"};
    for (const json& each : advice["change"]["set"]) {
        arguments.emplace_back("--set");
        arguments.push_back(each["key"].get<std::string>() + "=" + each["to"].dump());
    }
    const json changed = json_of(run(arguments, folder_.path()).out);
    for (const json& phase : changed["phases"])
        EXPECT_EQ(phase["verdict"]["category"], "none");
}

TEST_F(Advise, HasAMarginPerParameterWithWhatLiesBeyond) {
    const json advice = document(friction);
    ASSERT_EQ(advice["margins"].size(), 1U);
    const json& margin = advice["margins"][0];
    EXPECT_EQ(margin["key"], "contact.kinetic_friction");
    EXPECT_EQ(margin["value"], 0.6);
    EXPECT_EQ(margin["unit"], "1");
    // between squeal and silence lies what its errors leave open
    EXPECT_EQ(margin["below"]["category"], "undecided");
    EXPECT_NEAR(margin["below"]["value"].get<double>(), 0.4130, 3e-3);
    EXPECT_NEAR(margin["below"]["distance"].get<double>(), 0.1870, 3e-3);
    EXPECT_EQ(margin["above"]["phases"]["coming"], "undecided") << "from one of its starts";
    EXPECT_EQ(margin["end_above"]["why"], "range");
    EXPECT_EQ(advice["ranking"], json::array({"contact.kinetic_friction"}));
    EXPECT_TRUE(advice["chance"].is_null());
}

// a lip that squeals at 6.014 N is not quiet at 6 N without a word
TEST_F(Advise, SaysQuietWithItsMargin) {
    write_text(folder_ / "quiet.toml", run({"init", "quiet"}).out);
    const Finished asked = run({"advise", "quiet.toml", "--over", "mu_d", "--json"}, folder_.path());
    const json far = json_of(asked.out);
    EXPECT_EQ(far["present"]["quiet"], true);
    EXPECT_EQ(far["near"]["within"], 0.05);
    EXPECT_NE(far["standing"], "quiet_here");
    EXPECT_TRUE(far["headline"].get<std::string>().starts_with("quiet")) << far["headline"];
    EXPECT_EQ(far["chance"]["usual"], true) << "within tolerances that nobody named";
    EXPECT_GT(far["chance"]["tolerances"].size(), 3U);
    for (const json& turn : far["near"]["turns"])
        EXPECT_LE(std::abs(turn["relative"].get<double>()), 0.05);
}

TEST_F(Advise, JudgesBothWaysUnlessAskedForOne) {
    write_text(folder_ / "seal.toml", run({"init", "weatherstrip"}).out);
    std::vector<std::string> arguments{"advise", "seal.toml", "--over", "preload=7:9", "--json"};
    const json both = json_of(run(arguments, folder_.path()).out);
    EXPECT_EQ(both["phases"], json::array({"going", "coming"}));
    EXPECT_EQ(both["present"]["phases"]["coming"], "squeal");
    EXPECT_EQ(both["headline"], "locks while going, squeals while coming");
    arguments.insert(arguments.end(), {"--direction", "going", "--start", "rest"});
    const json one = json_of(run(arguments, folder_.path()).out);
    EXPECT_EQ(one["phases"], json::array({"going"}));
    EXPECT_EQ(one["starts"], json::array({"rest"}));
}

TEST_F(Advise, SaysTheSameWithAnyNumberOfThreads) {
    std::vector<std::string> arguments = friction;
    arguments.insert(arguments.end(), {"--tolerance", "preload=10%", "--samples", "32", "--json", "--threads", "1"});
    const std::string one = advise(arguments).out;
    arguments.back() = "5";
    EXPECT_EQ(advise(arguments).out, one);
    EXPECT_NE(one, "");
}

TEST_F(Advise, TellsTheChanceOfNoise) {
    std::vector<std::string> arguments = friction;
    arguments.insert(arguments.end(), {"--tolerance", "F=2 N", "--tolerance", "mu_d=5 % normal", "--samples", "40"});
    const json chance = document(arguments)["chance"];
    EXPECT_EQ(chance["samples"], 64);  // 16 times a power of two
    EXPECT_EQ(chance["noise"], 1.0);
    EXPECT_LT(chance["low"], 1.0);
    EXPECT_EQ(chance["confidence"], 0.95);
    EXPECT_EQ(chance["tolerances"][0]["tolerance"], 2.0);
    EXPECT_EQ(chance["tolerances"][1]["spread"], "normal");
    EXPECT_NEAR(chance["tolerances"][1]["tolerance"].get<double>(), 0.03, 1e-12);
}

TEST_F(Advise, RefusesWhatMakesNoSense) {
    expect_refused({"--over", "preload=10"}, {"--over preload=10", "KEY=FROM:TO"});
    expect_refused({"--over", "preload=1:2:3"}, {"KEY=FROM:TO"});
    expect_refused({"--over", "preload=50:5"}, {"Swap them?"});
    expect_refused({"--over", "prelod"}, {"Did you mean contact.preload?"});
    expect_refused({"--over", "mass=0.1:1"}, {"joint.mass or plate.mass"});
    expect_refused({"--over", "preload=3 mm:5 mm"}, {"force"});
    expect_refused({"--over", "preload=nan:5"}, {"nan"});
    expect_refused({"--over", "drive.velocity"}, {"changes nothing"});
    expect_refused({"--over", "run.duration"}, {"has no usual range"});
    expect_refused({"--tolerance", "preload"}, {"--tolerance preload", "preload=10%"});
    expect_refused({"--tolerance", "preload="}, {"preload=10%"});
    expect_refused({"--tolerance", "preload=normal"}, {"preload=10%"});
    expect_refused({"--tolerance", "preload=150%"}, {"reaches -10", "Make it smaller"});
    expect_refused({"--tolerance", "preload=3 mm"}, {"force"});
    expect_refused({"--tolerance", "preload=10%", "--samples", "0"}, {"samples"});
    expect_refused({"--direction", "up"}, {"direction"});
    expect_refused({"--set", "contact.kinetic_friction=0.9"}, {"mu_s"});
}

TEST_F(Advise, EndsWithCode4WhenInterrupted) {
    // steps of 50 ns: a minute of work
    Launch launch;
    launch.arguments = {"advise", "squeal.toml", "--set", "run.engine=beta_2", "--set", "run.step=5e-8"};
    launch.folder = folder_.path();
    Process process(launch);
    ASSERT_TRUE(wait_until([&] { return process.handles(SIGINT); }));
    process.send(SIGINT);
    const Finished finished = process.wait();
    EXPECT_EQ(finished.exit_code, 4) << finished.err;
    EXPECT_EQ(finished.out, "");
}
