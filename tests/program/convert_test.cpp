#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

const std::string fixtures = STRIDOR_SOURCE_DIR "/tests/fixtures/signals/";

void expect_refused(const Finished& finished, int exit_code, const std::string& word) {
    EXPECT_EQ(finished.signal, 0) << finished.err;
    EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find(word), std::string::npos) << finished.err;
}

}  // namespace

TEST(Convert, KeepsEveryFormatsSamplesOnTheWayRound) {
    const ScratchFolder folder;
    const std::vector<std::vector<std::string>> steps{{fixtures + "scipy_16.wav", "a.csv"},
                                                      {"a.csv", "b.uff"},
                                                      {"b.uff", "c.uff", "--format", "uff58"},
                                                      {"c.uff", "d.wav", "--bits", "16"}};
    for (std::vector<std::string> step : steps) {
        step.insert(step.begin(), "convert");
        const Finished finished = run(step, folder.path());
        ASSERT_EQ(finished.exit_code, 0) << finished.err;
    }
    const std::string back = read_text(folder / "d.wav");
    const std::string first = read_text(fixtures + "scipy_16.wav");
    EXPECT_EQ(back.substr(back.size() - 256), first.substr(first.size() - 256));
}

TEST(Convert, PrintsOneJsonDocumentWithUnits) {
    const Finished finished = run({"convert", fixtures + "scipy_16.wav", "--full-scale", "2 Pa", "--json"});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    const nlohmann::json document = json_of(finished.out);
    EXPECT_EQ(document["schema"], "stridor.convert/1");
    EXPECT_EQ(document["rate"], 48000.0);
    EXPECT_EQ(document["frames"], 64);
    EXPECT_EQ(document["channels"][0]["unit"], "Pa");
    EXPECT_EQ(document["channels"][0]["peak"], 1.0);
    EXPECT_EQ(document["channels"][0]["calibration"], "option");
}

TEST(Convert, SaysWhatWasUnderstood) {
    const std::string table = "n;Zeit t / s;Kraft [kN]\n0;0,0;0,5\n1;0,1;-1,5\n2;0,2;0,7\n";
    const ScratchFolder folder;
    const nlohmann::json document = json_of(run({"convert", "-", "--json"}, folder.path(), table).out);
    EXPECT_EQ(document["time"], "column 2, \"Zeit t\" in s");
    EXPECT_EQ(document["channels"][0]["unit_in_file"], "kN");
    EXPECT_EQ(document["left_out"][0].get<std::string>().substr(0, 13), "column 1, \"n\"");
    const std::string report = run({"convert", "-"}, folder.path(), table).out;
    EXPECT_NE(report.find("  channel 1 Kraft: peak 1500 N (written in kN)\n  left out  column 1"), std::string::npos);
}

TEST(Convert, ReadsAPipeAndWritesToOne) {
    const ScratchFolder folder;
    const Finished finished = run({"convert", "-", "-", "--format", "csv"}, folder.path(), "# rate: 2\n0.5\n-1\n");
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(finished.out.find("\ntime [s],channel 1 [FS]\n0,0.5\n0.5,-1\n"), std::string::npos) << finished.out;
    EXPECT_NE(finished.err.find("standard input"), std::string::npos) << finished.err;
}

TEST(Convert, OverwritesItsOwnInputSafely) {
    const ScratchFolder folder;
    write_text(folder / "a.wav", read_text(fixtures + "sox_24.wav"));
    const Finished finished = run({"convert", "a.wav", "a.wav", "--bits", "float"}, folder.path());
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_NE(run({"convert", "a.wav"}, folder.path()).out.find("32 bit float"), std::string::npos);
}

TEST(Convert, EndsWithTwoForBadInputAndFiveForFiles) {
    const ScratchFolder folder;
    write_text(folder / "text.wav", "no sound");
    write_text(folder / "empty.csv", "");
    write_text(folder / "cut.wav", read_text(fixtures + "scipy_16.wav").substr(0, 100));
    expect_refused(run({"convert", "text.wav"}, folder.path()), 2, "this is text and no sound");
    expect_refused(run({"convert", "empty.csv"}, folder.path()), 2, "the file is empty");
    expect_refused(run({"convert", "cut.wav", "b.csv"}, folder.path()), 2, "cut off");
    expect_refused(run({"convert", fixtures + "scipy_nan.wav", "b.csv"}, folder.path()), 2, "sample 41");
    expect_refused(run({"convert", fixtures + "scipy_16.wav", "b.xyz"}, folder.path()), 2, "--format");
    expect_refused(run({"convert", fixtures + "scipy_16.wav", "--full-scale", "2"}, folder.path()), 2, "no unit");
    expect_refused(run({"convert", fixtures + "scipy_16.wav", "-", "--format", "wav"}, folder.path()), 2,
                   "standard output");
    expect_refused(run({"convert", "missing.wav"}, folder.path()), 5, "missing.wav");
    expect_refused(run({"convert", "."}, folder.path()), 5, "it is a folder");
    expect_refused(run({"convert", fixtures + "scipy_16.wav", "no/b.csv"}, folder.path()), 5, "no/b.csv");
    EXPECT_FALSE(std::filesystem::exists(folder / "b.csv"));
}
