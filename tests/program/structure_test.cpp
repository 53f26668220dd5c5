// stridor structure, from outside: what it prints, writes and refuses.

#include "support/json_of.hpp"
#include "support/needs.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;
using stridor::support::ScratchFolder;

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

const std::string block = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/calculix/block.sti";

TEST(Structure, CheckTellsFrequenciesAsJson) {
    const auto document = json_of(run({"structure", "check", block, "--json"}).out);
    EXPECT_EQ(document["schema"], "stridor.part/1");
    EXPECT_EQ(document["rows"], 144);
    EXPECT_EQ(document["rigid_body_modes"], 0);
    EXPECT_NEAR(document["frequencies"][0].get<double>(), 616.90354105, 1e-7);
    EXPECT_EQ(document["sets"]["FOOT"].size(), 12U);
}

TEST(Structure, ShowsTheSlidingModesOfAllNodesThatMove) {
    const ScratchFolder folder;
    const auto reduced = [&](const char* set) {
        return run({"structure", "reduce", block, "--boundary", "FOOT", "--modes", "12", "--normal", "3", "--recover",
                    set, "-o", "block.nc"},
                   folder.path());
    };
    ASSERT_EQ(reduced("NALL").exit_code, 0);
    EXPECT_EQ(reduced("TOP").exit_code, 2) << "all of it is held";
    std::ofstream(folder / "case.toml")
        << "[structure]\nfile = \"block.nc\"\ndamping_ratio = 0.001\n[[structure.contact]]\nset = \"FOOT\"\n"
           "normal = \"z\"\ntangent = \"x\"\n[contact]\npreload = \"5 N\"\nstatic_friction = 0.5\n"
           "kinetic_friction = 0.4\n[drive]\nkind = \"constant\"\nvelocity = \"0.1 m/s\"\n"
           "[run]\nduration = \"0.1 s\"\nwindow = \"0.05 s\"\n";
    const std::string deck = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/calculix/block.inp";
    const Finished drawn =
        run({"figure", "mode-shapes", "case.toml", "--mesh", deck, "-o", "modes.vtu"}, folder.path());
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(drawn.err, "") << "no element is left out";
    const std::string text = text_of(folder / "modes.vtu");
    EXPECT_TRUE(contains(text, "NumberOfPoints=\"60\" NumberOfCells=\"24\"")) << text.substr(0, 300);
    EXPECT_TRUE(contains(text, "_Hz_imaginary\""));
    const Finished listed = run({"stability", "case.toml", "--csv", "modes.csv"}, folder.path());
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    EXPECT_TRUE(contains(text_of(folder / "modes.csv"),
                         "\ndirection,sliding,frequency [Hz],growth [1/s],damping_ratio,grows\n"));
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
    for (std::size_t mode = 0; mode < 3; ++mode)
        EXPECT_LT(std::abs(document["states"]["open"][mode]["error"].get<double>()), 3e-4);
    EXPECT_LT(document["flexibility_error"].get<double>(), 1e-10);
    const Finished check = run({"structure", "check", "block.nc", "--json"}, folder.path());
    const auto again = json_of(check.out);
    EXPECT_EQ(again["rows"], 48);
    EXPECT_NEAR(again["frequencies"][0].get<double>(), document["states"]["open"][0]["reduced"].get<double>(), 1e-8);
}

TEST(Structure, NotesANormalThatPointsOutOfThePartItReduces) {
    const ScratchFolder folder;
    const auto notes_of = [&](const std::string& normal) {
        const Finished reduced = run({"structure", "reduce", block, "--boundary", "FOOT", "--modes", "20",
                                      "--normal=" + normal, "-o", "block.nc"},
                                     folder.path());
        EXPECT_EQ(reduced.exit_code, 0) << reduced.err;
        EXPECT_TRUE(contains(reduced.out, "\nsliding")) << reduced.out;
        return reduced.err;
    };
    EXPECT_EQ(notes_of("3").find("the normal"), std::string::npos);
    EXPECT_TRUE(contains(notes_of("-3"), "the normal -z points out of the part at 12 of 12 nodes")) << notes_of("-3");
    EXPECT_TRUE(contains(notes_of("1"), "are normal and tangent swapped?")) << notes_of("1");
}

TEST(Structure, SaysWhoFactorised) {
    const ScratchFolder folder;
    const auto reduced_by = [&](const std::string& solver, bool as_json) {
        std::vector<std::string> arguments{"structure", "reduce", block,      "--boundary", "FOOT",
                                           "-o",        "x.nc",   "--solver", solver};
        if (as_json) arguments.emplace_back("--json");
        return run(arguments, folder.path());
    };
    EXPECT_EQ(json_of(reduced_by("eigen", true).out)["solver"], "eigen");
    EXPECT_EQ(reduced_by("eigen", false).out.find("MUMPS"), std::string::npos);
    EXPECT_EQ(reduced_by("pardiso", false).exit_code, 2);
    const Finished reduced = reduced_by("mumps", false);
    const bool has_mumps = reduced.err.find("has no MUMPS") == std::string::npos;
    EXPECT_EQ(reduced.exit_code, has_mumps ? 0 : 2);
    STRIDOR_NEEDS(has_mumps, "MUMPS", "libmumps-headers-dev libmumps-seq-5.5");
    EXPECT_NE(reduced.out.find("solver       MUMPS"), std::string::npos) << reduced.err;
    EXPECT_EQ(json_of(reduced_by("mumps", true).out)["solver"], "mumps");
}

TEST(Structure, TellsWhatItsContactsDoWhereNoForcesObeyTheLaws) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "painleve.toml") << R"([structure]
rows = ["x", "y"]
mass = [[1, 0.8], [0.8, 1]]
stiffness = [[100, 0], [0, 100]]
damping = [[0.1, 0], [0, 0.1]]
[[structure.contact]]
name = "foot"
normal = "y"
tangent = "x"
[contact]
preload = "1 N"
static_friction = 1.5
kinetic_friction = 1.3
[drive]
kind = "constant"
velocity = "0.1 m/s"
[run]
initial = "rest"
)";
    const Finished refused = run({"simulate", "painleve.toml", "--json"}, folder.path());
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.err.find("no forces obey all laws of contact at 0 s of 1 s; foot slips"), std::string::npos)
        << refused.err;
    const auto outcome = json_of(refused.out)["outcome"];
    EXPECT_NE(refused.err.find("friction presses foot together without end"), std::string::npos) << refused.err;
    EXPECT_EQ(outcome["reason"], "painleve");
    EXPECT_EQ(outcome["contacts"][0]["name"], "foot");
    EXPECT_EQ(outcome["contacts"][0]["state"], "slip");
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

// what is no part ends with the sentence that says so, alone
TEST(Structure, RefusesBadPartsEachByItsOwnSentence) {
    const ScratchFolder folder;
    const auto refused = [&](std::vector<std::string> arguments, const std::string& sentence) {
        const Finished finished = run(arguments, folder.path());
        EXPECT_EQ(finished.exit_code, 2) << finished.err;
        EXPECT_EQ(finished.out, "");
        const std::size_t at = finished.err.find("error: " + sentence);
        EXPECT_NE(at, std::string::npos) << finished.err;
        EXPECT_EQ(finished.err.find("error:", at == std::string::npos ? 0 : at + 1), std::string::npos) << finished.err;
    };
    const auto put = [&](const std::string& name, const std::string& text) {
        stridor::support::write_text(folder.path() / name, text);
    };
    const std::string symmetric = "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n";
    const std::string general = "%%MatrixMarket matrix coordinate real general\n2 2 4\n";
    put("k.mtx", symmetric + "1 1 2\n2 1 -1\n2 2 2\n");
    put("m.mtx", symmetric + "1 1 1\n2 1 0.5\n2 2 1\n");
    put("rows.csv", "node,component\n7,1\n7,2\n");
    const auto part = [](const std::string& stiffness, const std::string& mass) {
        return std::vector<std::string>{"structure", "check", "--stiffness", stiffness,
                                        "--mass",    mass,    "--labels",    "rows.csv"};
    };
    EXPECT_EQ(run(part("k.mtx", "m.mtx"), folder.path()).exit_code, 0);

    put("job_STIF1.mtx", "7,1, 7,1, 2.0\n8,1, 8,1, 2.0\n");
    put("job_MASS1.mtx", "7,1, 7,1, 1.0\n9,1, 9,1, 1.0\n");
    refused({"structure", "check", "job_STIF1.mtx", "job_MASS1.mtx"},
            "the mass has a row 9.1 that the stiffness lacks (both must be of the same model)");
    put("long.csv", "node,component\n7,1\n7,2\n8,1\n");
    auto arguments = part("k.mtx", "m.mtx");
    arguments.back() = "long.csv";
    refused(arguments, "it labels 3 rows, the stiffness has 2");

    put("indefinite.mtx", symmetric + "1 1 1\n2 1 3\n2 2 1\n");
    refused(part("k.mtx", "indefinite.mtx"), "the mass is negative for some motion (1 of its pivots are negative)");
    put("negative.mtx", symmetric + "1 1 1\n2 1 0.1\n2 2 -1\n");
    refused(part("k.mtx", "negative.mtx"), "the mass is negative for some motion (row 7.2 has -1 on its diagonal)");
    put("unsymmetric.mtx", general + "1 1 2\n1 2 -1\n2 1 -1.5\n2 2 2\n");
    refused(part("unsymmetric.mtx", "m.mtx"), "the matrix is not symmetric (at row ");
    refused(part("k.mtx", "unsymmetric.mtx"), "the matrix is not symmetric (at row ");
    put("buckled.mtx", symmetric + "1 1 2\n2 1 -3\n2 2 2\n");
    refused(part("buckled.mtx", "m.mtx"), "the stiffness is negative for some motion");

    arguments = part("k.mtx", "m.mtx");
    arguments.insert(arguments.end(), {"--contact", "99"});
    refused(arguments, "\"99\" is no set, node or row");
    const auto with_contact = [](const std::string& contact) {
        return "[structure]\nstiffness = \"k.mtx\"\nmass = \"m.mtx\"\nlabels = \"rows.csv\"\n"
               "[[structure.contact]]\n" +
               contact +
               "[contact]\npreload = \"5 N\"\nstatic_friction = 0.8\nkinetic_friction = 0.6\n[drive]\nkind = "
               "\"constant\"\nvelocity = \"20 mm/s\"\n";
    };
    put("good.toml", with_contact("node = 7\nnormal = \"y\"\ntangent = \"x\"\n"));
    EXPECT_EQ(run({"check", "good.toml"}, folder.path()).exit_code, 0);
    put("missing.toml", with_contact("node = 99\nnormal = \"y\"\ntangent = \"x\"\n"));
    refused({"simulate", "missing.toml"}, "\"99\" is no set, node or row");
    put("zero.toml", with_contact("node = 7\nnormal = [0, 0, 0]\ntangent = \"x\"\n"));
    refused({"simulate", "zero.toml"}, "the normal is zero (it has no direction)");
}

}  // namespace
