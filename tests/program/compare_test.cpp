// Sounds side by side, from outside.

#include "support/effort.hpp"
#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

const std::vector<std::string> coarse{"--set", "chart.x.points=4",
                                      "--set", "chart.y.points=3",
                                      "--set", stridor::support::effort("run.duration=0.3 s", "run.duration=0.2 s"),
                                      "--set", stridor::support::effort("run.window=0.15 s", "run.window=0.1 s")};

const ScratchFolder& folder() {
    static const ScratchFolder shared;
    static const bool is_filled = [] {
        write_text(shared / "squeal.toml", run({"init", "squeal"}).out);
        write_text(shared / "pair.toml", run({"init", "noise-chart"}).out);
        std::vector<std::string> listen{"listen", "pair.toml", "--cell", "x=20 N,y=0.7", "--out", "cell.wav"};
        listen.insert(listen.end(), coarse.begin(), coarse.end());
        EXPECT_EQ(run(listen, shared.path()).exit_code, 0);
        write_text(shared / "silence.csv", "time [s],sound [Pa]\n0,0\n0.001,0\n0.002,0\n0.003,0\n");
        return true;
    }();
    (void)is_filled;
    return shared;
}

Finished answer(const std::vector<std::string>& arguments) {
    return run(arguments, folder().path());
}

json document_of(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    const Finished finished = answer(arguments);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json_of(finished.out);
}

std::vector<std::string> match(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"match", "cell.wav", "--chart", "pair.toml"});
    arguments.insert(arguments.end(), coarse.begin(), coarse.end());
    return arguments;
}

}  // namespace

TEST(Compare, LaysRecordingAndCaseSideBySide) {
    const json document = document_of({"compare", "cell.wav", "squeal.toml", "--label", "rig", "--label", "model"});
    EXPECT_EQ(document["schema"], "stridor.compare/1");
    ASSERT_EQ(document["sounds"].size(), 2U);
    EXPECT_EQ(document["sounds"][0]["origin"], "recording");
    EXPECT_TRUE(document["sounds"][0]["contact"].empty());
    EXPECT_TRUE(document["sounds"][0]["figures"]["slip"].is_null());
    EXPECT_EQ(document["sounds"][1]["label"], "model");
    EXPECT_EQ(document["sounds"][1]["category"], "squeal");
    EXPECT_EQ(document["sounds"][1]["contact"].size(), 2U) << "going and coming";
    EXPECT_EQ(document["pairs"].size(), 1U);
    EXPECT_GT(document["pairs"][0]["distance"].get<double>(), 0.0);
}

TEST(Compare, FindsNothingBetweenASoundAndItself) {
    const json document = document_of({"compare", "cell.wav", "cell.wav"});
    EXPECT_EQ(document["pairs"][0]["distance"], 0.0);
}

TEST(Compare, BringsMixedRatesToTheLowest) {
    ASSERT_EQ(answer({"listen", "squeal.toml", "--seconds", "0.3", "--rate", "16000", "--out", "low.wav"}).exit_code,
              0);
    const json document = document_of({"compare", "low.wav", "cell.wav"});
    EXPECT_EQ(document["sounds"][1]["rate"], 48000.0);
    EXPECT_EQ(document["sounds"][1]["compared_at"], 16000.0);
}

TEST(Compare, DrawsAFigure) {
    ASSERT_EQ(answer({"figure", "compare", "cell.wav", "pair.toml:x=20 N,y=0.6", "-o", "compare.svg"}).exit_code, 0);
    EXPECT_GT(std::filesystem::file_size(folder() / "compare.svg"), 10000U);
}

TEST(Compare, RefusesWhatIsNoSoundWithAReason) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
        {{"cell.wav"}, "1 sound cannot"},
        {std::vector<std::string>(9, "cell.wav"), "9 sounds cannot"},
        {{"cell.wav", "nowhere.wav"}, "nowhere.wav"},
        {{"cell.wav", "library:x"}, "names no entry"},
        {{"cell.wav", "cell.wav:channel=0"}, "there is no channel \"0\""},
        {{"cell.wav", "pair.toml:x=20 N"}, "one axis only"},
        {{"cell.wav", "pair.toml:x=20 N,y=9"}, "outside the chart"},
        {{"cell.wav", "squeal.toml:x=20 N,y=0.6"}, "[chart]"},
        {{"cell.wav", "cell.wav", "--label", "one"}, "1 labels for 2 sounds"},
        {{"-", "-"}, "read once"},
    };
    for (auto [arguments, words] : wrong) {
        arguments.insert(arguments.begin(), "compare");
        const Finished finished = answer(arguments);
        EXPECT_TRUE(finished.exit_code == 2 || finished.exit_code == 5) << words << ": " << finished.exit_code;
        EXPECT_NE(finished.err.find(words), std::string::npos) << words << " not in: " << finished.err;
        EXPECT_TRUE(finished.out.empty());
    }
}

TEST(Compare, ShowsSilenceAndShortSoundsAsSuch) {
    const Finished finished = answer({"compare", "cell.wav", "silence.csv"});
    // 1 kHz is the lowest rate that can be analysed; the sound is shorter than any stretch
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(finished.out.find("undecided"), std::string::npos) << finished.out;
}

TEST(Match, FindsTheCellThatWasRecorded) {
    const json document = document_of(match({"--best", "2", "--out", "matches"}));
    EXPECT_EQ(document["schema"], "stridor.match/1");
    ASSERT_EQ(document["matches"].size(), 2U);
    const json& first = document["matches"][0];
    EXPECT_LT(first["distance"].get<double>(), document["matches"][1]["distance"].get<double>());
    // the cell nearest to x=20 N, y=0.7 of 4 by 3
    EXPECT_EQ(first["x"]["index"], 1) << first.dump(2);
    EXPECT_EQ(first["y"]["index"], 2);
    EXPECT_EQ(first["direction"], "going");
    for (const char* name : {"match.png", "match.svg", "match.json", "match-1.wav", "match-2.wav"})
        EXPECT_TRUE(std::filesystem::exists(folder() / "matches" / name)) << name;
}

TEST(Match, LeavesOutWhatTheStoreKnowsToBeQuiet) {
    std::vector<std::string> chart{"chart", "pair.toml", "--out", "pair"};
    chart.insert(chart.end(), coarse.begin(), coarse.end());
    ASSERT_EQ(answer(chart).exit_code, 0);
    const json document = document_of(match({"--store", "pair/chart.sqlite"}));
    EXPECT_GT(document["chart"]["ruled_out"].get<int>(), 0);
    EXPECT_EQ(document["matches"][0]["x"]["index"], 1);
}

TEST(Match, RefusesWhatCannotBeMatched) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
        {{"silence.csv", "--chart", "pair.toml"}, "too short"},
        {{"squeal.toml", "--chart", "pair.toml"}, "no recording"},
        {{"cell.wav", "--chart", "squeal.toml"}, "[chart]"},
        {{"cell.wav", "--chart", "pair.toml", "--with-level", "--quantity", "acceleration"}, "cannot be compared"},
        {{"cell.wav", "--chart", "pair.toml", "--store", "nowhere.sqlite"}, "no store"},
    };
    for (auto [arguments, words] : wrong) {
        arguments.insert(arguments.begin(), "match");
        const Finished finished = answer(arguments);
        EXPECT_TRUE(finished.exit_code == 2 || finished.exit_code == 5) << words << ": " << finished.exit_code;
        EXPECT_NE(finished.err.find(words), std::string::npos) << words << " not in: " << finished.err;
    }
}
