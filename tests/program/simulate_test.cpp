#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

json simulated(const std::string& kind, const std::vector<std::string>& more = {}) {
    const ScratchFolder folder;
    write_text(folder / "case.toml", run({"init", kind}).out);
    std::vector<std::string> arguments{"simulate", "case.toml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = run(arguments, folder.path());
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json_of(finished.out);
}

std::map<std::string, std::string> categories(const json& document) {
    std::map<std::string, std::string> found;
    for (const json& phase : document["phases"])
        found[phase["phase"]] = phase["verdict"]["category"];
    return found;
}

}  // namespace

TEST(Simulate, GivesTheFourCategoriesOfThePaper) {
    using Categories = std::map<std::string, std::string>;
    EXPECT_EQ(categories(simulated("quiet")), (Categories{{"going", "none"}, {"coming", "none"}}));
    EXPECT_EQ(categories(simulated("squeal")), (Categories{{"going", "squeal"}, {"coming", "none"}}));
    EXPECT_EQ(categories(simulated("squeak"))["going"], "squeak");
    EXPECT_EQ(categories(simulated("creak")), (Categories{{"going", "creak"}, {"coming", "creak"}}));
}

TEST(Simulate, DocumentHoldsWhatTheContractSays) {
    const json document = simulated("squeal");
    EXPECT_EQ(document["schema"], "stridor.simulation/1");
    EXPECT_EQ(document["case"]["contact"]["preload"], 20.0);
    EXPECT_EQ(document["engine"]["name"], "exact");
    EXPECT_EQ(document["engine"]["impact"], "plastic");
    EXPECT_LT(std::abs(document["energy"]["relative_residual"].get<double>()), 1e-9);
    ASSERT_EQ(document["phases"].size(), 2U);
    for (const json& phase : document["phases"]) {
        const json& verdict = phase["verdict"];
        const json& rates = verdict["rates"];
        EXPECT_NEAR(rates["slip"].get<double>() + rates["stick"].get<double>() + rates["separation"].get<double>(), 1.0,
                    1e-9);
        for (const char* key : {"category", "regularity", "period", "frequency", "levels", "margins"})
            EXPECT_TRUE(verdict.contains(key)) << key;
        EXPECT_TRUE(phase.contains("window"));
        EXPECT_GE(verdict["margins"].size(), 3U);
    }
}

TEST(Simulate, AConstantDriveHasOnePhaseCalledAll) {
    const json document = simulated("squeal", {"--set", "drive.kind=constant", "--set", "drive.velocity=0.1"});
    ASSERT_EQ(document["phases"].size(), 1U);
    EXPECT_EQ(document["phases"][0]["phase"], "all");
    EXPECT_EQ(document["phases"][0]["verdict"]["category"], "squeal");
}

TEST(Simulate, ReadsACaseFromStandardInput) {
    const Finished finished = run({"simulate", "-"}, {}, run({"init", "quiet"}).out);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(finished.out.find("none"), std::string::npos);
}

TEST(Simulate, DataGoesToStdoutAndMessagesToStderr) {
    const Finished finished = run({"simulate", "-", "--json"}, {}, run({"init", "quiet"}).out);
    EXPECT_EQ(finished.err, "");
    EXPECT_NO_THROW(json_of(finished.out));
}

// what is left of the motion as the contact jams is no vibration
TEST(Simulate, GivesNoLevelToAContactThatLocks) {
    const Finished finished = run({"simulate", "-"}, {}, run({"init", "weatherstrip"}).out);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(finished.out.find("all     locks"), std::string::npos) << finished.out;
    EXPECT_EQ(finished.out.find(" dB\n"), std::string::npos) << finished.out;
}

// a choice left to the program says what was taken; the numbers are those of the engine by its name
TEST(Simulate, ChoosesAnEngineAndSaysWhich) {
    const auto named = [](const std::vector<std::string>& sets, const std::string& engine) {
        std::vector<std::string> arguments{"--set", "run.engine=" + engine, "--set", "run.duration=0.3",
                                           "--set", "run.window=0.3"};
        arguments.insert(arguments.end(), sets.begin(), sets.end());
        return simulated("squeal", arguments);
    };
    const json exact = named({}, "auto");
    EXPECT_EQ(exact["engine"]["name"], "exact");
    EXPECT_EQ(exact["engine"]["asked"], "auto");
    EXPECT_EQ(exact["case"]["run"]["engine"], "auto");
    EXPECT_FALSE(exact["engine"].contains("chosen_since"));
    EXPECT_EQ(exact["phases"], named({}, "exact")["phases"]);

    const std::vector<std::string> power{"--set", "contact.friction=stribeck",
                                         "--set", "contact.stribeck_velocity=0.05",
                                         "--set", "contact.stribeck_exponent=1.5"};
    const json stepped = named(power, "auto");
    EXPECT_EQ(stepped["engine"]["name"], "moreau");
    EXPECT_EQ(stepped["engine"]["chosen_since"], "the exact engine has no power series of this law of friction");
    EXPECT_EQ(stepped["phases"], named(power, "moreau")["phases"]);
    // its step may be said, whichever is taken
    for (const auto& [sets, step] : {std::pair(power, json(2e-6)), std::pair(std::vector<std::string>{}, json())}) {
        std::vector<std::string> with_step = sets;
        with_step.insert(with_step.end(), {"--set", "run.step=2e-6"});
        EXPECT_EQ(named(with_step, "auto")["engine"].value("step", json()), step);
    }
}

TEST(Cases, ShippedFilesAreWhatInitPrints) {
    for (const std::string kind : {"squeal", "squeak", "creak", "quiet", "noise-chart", "rate-map", "weatherstrip",
                                   "weatherstrip-shaken", "glass-run", "clip", "wiper", "brake-pad", "wiper-wet",
                                   "weatherstrip-falling", "seal-lip", "two-lips", "chain", "string"})
        EXPECT_EQ(stridor::support::read_text(std::filesystem::path(STRIDOR_SOURCE_DIR) / "cases" / (kind + ".toml")),
                  run({"init", kind}).out)
            << kind;
}

// of two engines that share no code: events by Taylor series, and small steps
TEST(Cases, OfFrictionOverTheSlipVelocityAreJudgedAlikeByTwoEngines) {
    struct Judged {
        const char* kind;
        const char* velocity;
        const char* words;
    };
    for (const auto& [kind, velocity, words] :
         {Judged{"wiper-wet", "0.05", "all     squeal"}, Judged{"wiper-wet", "0.5", "all     none "},
          Judged{"weatherstrip-falling", "-0.05", "all     squeal"}})
        for (const char* engine : {"run.engine=exact", "run.engine=moreau"}) {
            const Finished finished =
                run({"simulate", "-", "--set", std::string("drive.velocity=") + velocity, "--set", engine}, {},
                    run({"init", kind}).out);
            EXPECT_EQ(finished.exit_code, 0) << finished.err;
            EXPECT_NE(finished.out.find(words), std::string::npos) << kind << ", " << engine << "\n" << finished.out;
        }
}

TEST(Check, PrintsTheResolvedCaseFrequenciesAndCost) {
    const Finished finished = run({"check", "-"}, {}, run({"init", "squeal"}).out);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    for (const char* words : {"incidence_angle", "70 deg", "429.17", "1591.55", "steps and the events"})
        EXPECT_NE(finished.out.find(words), std::string::npos) << words;
}

TEST(Stability, FindsTheFlutterOnset) {
    const ScratchFolder folder;
    write_text(folder / "case.toml", run({"init", "squeal"}).out);
    const Finished finished =
        run({"stability", "case.toml", "--over", "contact.kinetic_friction=0:0.8", "--json"}, folder.path());
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    const json document = json_of(finished.out);
    const json& boundaries = document["directions"][0]["boundaries"];
    ASSERT_EQ(boundaries.size(), 1U) << document.dump(1);
    EXPECT_NEAR(boundaries[0]["value"].get<double>(), 0.44942, 5e-4);
    EXPECT_TRUE(document["directions"][1]["boundaries"].empty());
}
