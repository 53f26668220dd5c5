// stridor structure, from outside: what it prints, writes and refuses.

#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;
using stridor::support::ScratchFolder;

namespace {

const std::string block = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/calculix/block.sti";

TEST(Structure, CheckTellsFrequenciesAsJson) {
    const auto document = json_of(run({"structure", "check", block, "--json"}).out);
    EXPECT_EQ(document["schema"], "stridor.part/1");
    EXPECT_EQ(document["rows"], 144);
    EXPECT_EQ(document["rigid_body_modes"], 0);
    EXPECT_NEAR(document["frequencies"][0].get<double>(), 616.90354105, 1e-7);
    EXPECT_EQ(document["sets"]["FOOT"].size(), 12U);
}

TEST(Structure, ReducesAndReadsWhatItWrote) {
    const ScratchFolder folder;
    const Finished reduced = run({"structure", "reduce", block, "--boundary", "FOOT", "--modes", "12", "--normal", "3",
                                  "--inertia", "consistent", "--recover", "1030", "1031.3", "-o", "block.nc", "--json"},
                                 folder.path());
    ASSERT_EQ(reduced.exit_code, 0) << reduced.err;
    const auto document = json_of(reduced.out);
    EXPECT_EQ(document["boundary_rows"], 36);
    EXPECT_EQ(document["mode_frequencies"].size(), 12U);
    for (int mode = 0; mode < 3; ++mode)
        EXPECT_LT(std::abs(document["states"]["open"][mode]["error"].get<double>()), 3e-4);
    EXPECT_LT(document["flexibility_error"].get<double>(), 1e-10);
    const Finished check = run({"structure", "check", "block.nc", "--json"}, folder.path());
    const auto again = json_of(check.out);
    EXPECT_EQ(again["rows"], 48);
    EXPECT_NEAR(again["frequencies"][0].get<double>(), document["states"]["open"][0]["reduced"].get<double>(), 1e-8);
}

TEST(Structure, IsInSiWhateverItsUnits) {
    const auto document = json_of(run({"structure", "info", block, "--units", "cm-g-s", "--json"}).out);
    EXPECT_NEAR(document["mass"][0].get<double>(), 1.92e-6, 1e-8);
    EXPECT_NEAR(document["extent"][0].get<double>(), 2e-4, 1e-9);
}

TEST(Structure, RefusesWithASentenceAndExitCode2) {
    const ScratchFolder folder;
    const auto refused = [&](std::vector<std::string> arguments, const std::string& sentence, int code = 2) {
        arguments.insert(arguments.begin(), "structure");
        const Finished finished = run(arguments, folder.path());
        EXPECT_EQ(finished.exit_code, code) << finished.err;
        EXPECT_EQ(finished.out, "");
        EXPECT_NE(finished.err.find(sentence), std::string::npos) << finished.err;
    };
    refused({"info"}, "no file of a part is named");
    refused({"info", "gone.sti"}, "cannot read \"gone.sti\"", 5);
    refused({"info", block, "--units", "inch"}, "\"inch\" is no system of units");
    refused({"reduce", block, "--boundary", "HEAD", "-o", "x.nc"}, "its node sets are NALL, TOP, FOOT");
    refused({"reduce", block, "--boundary", "TOP", "-o", "x.nc"}, "node 1048 has no row (a support");
    refused({"reduce", block, "--boundary", "FOOT", "--below", "8 kg", "-o", "x.nc"}, "kg");
    refused({"reduce", block, "--boundary", "FOOT"}, "--output");
    EXPECT_EQ(folder.files(), 0);
}

}  // namespace
