#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

using stridor::support::Finished;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

class ChartOfACase : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "squeal.toml", run({"init", "squeal"}).out); }

    Finished chart(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"chart", "squeal.toml"});
        return run(arguments, folder_.path());
    }

    std::string text(const std::string& file) const { return read_text(folder_.path() / file); }

    ScratchFolder folder_;
};

TEST_F(ChartOfACase, NeedsNoSectionInTheFile) {
    const Finished done = chart({"--x", "preload=10:40:3", "--y", "mu_d=0.2:0.8:4", "--out", "out"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("24 cells"), std::string::npos) << done.out;
    for (const char* file : {"chart.csv", "chart.nc", "chart.png", "chart.svg", "chart.sqlite", "boundaries.csv"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
    EXPECT_NE(text("out/chart.toml")
                  .find("x = { parameter = \"contact.preload\", from = \"10 N\", to = \"40 N\", "
                        "points = 3, scale = \"log\" }"),
              std::string::npos)
        << "what it resolves to, with the usual scale: " << text("out/chart.toml");
    EXPECT_NE(text("out/chart.svg").find("design"), std::string::npos) << "the case's own values are marked";
    const Finished from_file = run({"chart", "out/chart.toml", "--out", "again"}, folder_.path());
    ASSERT_EQ(from_file.exit_code, 0) << from_file.err;
    EXPECT_EQ(text("again/chart.csv"), text("out/chart.csv"));
}

// 80 rows make 100 kB of matrices: shares and resumed charts read them from there
TEST_F(ChartOfACase, IsReadAgainWhereItHoldsLargeMatrices) {
    constexpr int rows = 80;
    const auto matrix = [](double diagonal, double beside) {
        std::string text = "[";
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < rows; ++j)
                text += (j == 0 ? "[" : ", ") + std::to_string(i == j ? diagonal : beside / (1.0 + std::abs(i - j)));
            text += "],\n";
        }
        return text + "]\n";
    };
    write_text(folder_.path() / "large.toml",
               "[structure]\nmass = " + matrix(0.01, 0.0) + "stiffness = " + matrix(2e6, -1234.5) +
                   "[[structure.contact]]\nname = \"foot\"\nnormal = \"u1\"\ntangent = \"u2\"\n"
                   "[contact]\npreload = 20\nstatic_friction = 0.6\n"
                   "kinetic_friction = 0.4\n[drive]\nkind = \"constant\"\n"
                   "velocity = 0.1\n[run]\nduration = 2e-3\nwindow = 1e-3\n");
    const Finished first =
        run({"chart", "large.toml", "--x", "preload=10:40:2", "--y", "mu_d=0.2:0.4:2", "--out", "out"}, folder_.path());
    ASSERT_EQ(first.exit_code, 0) << first.err;
    ASSERT_GT(text("out/chart.toml").size(), 65536U);
    const Finished again = run({"chart", "out/chart.toml", "--out", "again"}, folder_.path());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(text("again/chart.csv"), text("out/chart.csv"));
}

TEST_F(ChartOfACase, WritesTheFilesAndFiguresThatAreAskedFor) {
    const std::vector<std::string> axes{"--x", "preload=10:40:3", "--y", "mu_d=0.2:0.8:4", "--out", "out"};
    std::vector<std::string> arguments = axes;
    arguments.insert(arguments.end(), {"--files", "pdf,csv,zarr", "--figures", "frequency"});
    const Finished done = chart(arguments);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("out/chart.pdf out/chart.csv out/chart.zarr out/chart.sqlite out/chart.toml\n"),
              std::string::npos)
        << done.out;
    for (const char* file : {"chart.pdf", "chart.csv", "chart.zarr/.zgroup", "chart.zarr/frequency/0.0.0"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
    for (const char* file : {"chart.nc", "chart.png", "chart.svg", "boundaries.csv", "chart.zarr/slip"})
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
    EXPECT_NE(text("out/chart.csv")
                  .find("\nx [N],y,direction,status,category,frequency [Hz],quiet_because,source,message,reproduce\n"),
              std::string::npos);
    for (const auto& [option, name] : {std::pair{"--files", "cvs"}, std::pair{"--figures", "frequenzy"}}) {
        arguments = axes;
        arguments.insert(arguments.end(), {option, name});
        const Finished wrong = chart(arguments);
        EXPECT_EQ(wrong.exit_code, 2);
        EXPECT_NE(wrong.err.find("Did you mean"), std::string::npos) << wrong.err;
    }
}

TEST_F(ChartOfACase, UnitsScaleAndCountAreUnderstood) {
    for (const char* x : {"preload=10:40 N:3:linear", "contact.preload = 10N : 0.04 kN : 3 : linear"}) {
        std::filesystem::remove_all(folder_.path() / "out");
        const Finished done = chart({"--x", x, "--y", "mu_d=0.5:0.6:2", "--out", "out"});
        ASSERT_EQ(done.exit_code, 0) << done.err;
        EXPECT_NE(text("out/chart.toml").find("from = \"10 N\", to = \"40 N\", points = 3, scale = \"linear\""),
                  std::string::npos);
    }
}

TEST_F(ChartOfACase, ADesignOutsideOfTheRangeIsSaid) {
    const Finished done = chart({"--x", "preload=30:40:2", "--y", "mu_d=0.5:0.6:2", "--out", "out"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.err.find("lies outside of the chart: contact.preload = 20 N, contact.kinetic_friction = 0.6"),
              std::string::npos)
        << done.err;
}

TEST_F(ChartOfACase, TheSameCommandResumesAndAnotherIsRefused) {
    const std::vector<std::string> same{"--x", "preload=10:40:3", "--y", "mu_d=0.2:0.6:3", "--out", "out"};
    ASSERT_EQ(chart(same).exit_code, 0);
    const std::string first = text("out/chart.csv");
    EXPECT_EQ(chart(same).exit_code, 0);
    EXPECT_EQ(text("out/chart.csv"), first);
    const Finished other = chart({"--x", "preload=10:50:3", "--y", "mu_d=0.2:0.6:3", "--out", "out"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("another study"), std::string::npos) << other.err;
}

TEST_F(ChartOfACase, OptionsTakeThePlaceOfTheFilesAxes) {
    write_text(folder_ / "pair.toml", run({"init", "noise-chart"}).out);
    const Finished done = run({"chart", "pair.toml", "--x", "velocity=0.05:0.2:2", "--y", "mu_d=0.2:0.6:2", "--set",
                               "chart.directions=going", "--out", "out"},
                              folder_.path());
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("4 cells"), std::string::npos) << done.out;
}

// a stiffness and a friction by table over the temperature
class ChartOverTemperature : public ChartOfACase {
protected:
    void SetUp() override {
        std::string table =
            "\n[temperature]\nvalue = \"23 degC\"\nat = [-30, 23, 80]\n"
            "k1j = [\"4e6 N/m\", \"1e6 N/m\", \"2e5 N/m\"]\nmu_d = [0.3, 0.6, 0.7]\n";
        std::string kept;
        std::istringstream lines(run({"init", "squeal"}).out);
        for (std::string line; std::getline(lines, line);)
            if (!line.starts_with("flexural_stiffness") && !line.starts_with("kinetic_friction")) kept += line + "\n";
        write_text(folder_ / "squeal.toml", kept + table);
    }

    Finished simulate(const std::string& set) const {
        return run({"simulate", "squeal.toml", "--json", "--set", set}, folder_.path());
    }
};

TEST_F(ChartOverTemperature, HasTheRunsOfEachTemperature) {
    const Finished done = chart({"--x", "preload=20:40:2", "--y", "temperature=-30:80:3", "--out", "out"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(text("out/chart.svg").find("°C"), std::string::npos);
    // near 23 degC it is the paper's squeal
    EXPECT_NE(text("out/chart.csv").find("\n20,25,going,done,squeal"), std::string::npos) << text("out/chart.csv");
    const Finished again = run({"chart", "out/chart.toml", "--out", "again"}, folder_.path());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(text("again/chart.csv"), text("out/chart.csv"));
    EXPECT_EQ(chart({"--x", "temperature=-30:80:3", "--out", "alone"}).exit_code, 0);
}

TEST_F(ChartOverTemperature, IsOfTheCasesThatASimulationSets) {
    const Finished cold = simulate("temperature=-30 degC");
    ASSERT_EQ(cold.exit_code, 0) << cold.err;
    EXPECT_NE(cold.out.find("\"flexural_stiffness\": 4000000.0"), std::string::npos) << cold.out;
    EXPECT_NE(cold.out.find("\"kinetic_friction\": 0.3"), std::string::npos);
    // the same motion as of a file with these numbers
    write_text(folder_ / "plain.toml", run({"init", "squeal"}).out);
    const Finished plain = run({"simulate", "plain.toml", "--set", "k1j=4e6", "--set", "mu_d=0.3"}, folder_.path());
    EXPECT_EQ(run({"simulate", "squeal.toml", "--set", "temperature=-30"}, folder_.path()).out, plain.out);
}

TEST_F(ChartOverTemperature, EndsWhereItsTableDoes) {
    for (const auto& [axis, words] : {std::pair("temperature=-31:80:3", "between -30 and 80 degC"),
                                      std::pair("mu_d=0.2:0.5:3", "contact.kinetic_friction cannot be set")}) {
        const Finished refused = chart({"--x", axis, "--out", "out"});
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_NE(refused.err.find(words), std::string::npos) << refused.err;
    }
    EXPECT_EQ(simulate("temperature=100").exit_code, 2);
    EXPECT_EQ(simulate("k1j=1e6").exit_code, 2);
    const Finished scan = run({"stability", "squeal.toml", "--over", "temperature=-30:80"}, folder_.path());
    EXPECT_EQ(scan.exit_code, 0) << scan.err;
    EXPECT_EQ(run({"stability", "squeal.toml", "--over", "temperature=-30:81"}, folder_.path()).exit_code, 2);
    EXPECT_EQ(run({"report", "squeal.toml", "--no-advice", "--points", "3", "-o", "r.html"}, folder_.path()).exit_code,
              0);
}

// the library gets the case of a trace back from its lines
TEST_F(ChartOverTemperature, GoesIntoTheLibraryWithATrace) {
    ASSERT_EQ(run({"simulate", "squeal.toml", "--trace", "t.csv"}, folder_.path()).exit_code, 0);
    const Finished added = run({"library", "add", "t.csv", "--library", "l.sqlite", "--no-verdict"}, folder_.path());
    ASSERT_EQ(added.exit_code, 0) << added.err;
    const Finished shown = run({"library", "show", "1", "--library", "l.sqlite", "--json"}, folder_.path());
    EXPECT_NE(shown.out.find("joint.flexural_stiffness = [\\\"4e6 N/m\\\""), std::string::npos) << shown.out;
}

TEST_F(ChartOfACase, OneAxisAloneGivesADiagram) {
    const Finished done = chart({"--x", "mu_d=0.2:0.7:11", "--out", "out"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("22 cells"), std::string::npos) << done.out;
    for (const char* file : {"chart.csv", "chart.nc", "chart.png", "chart.svg", "diagram.csv", "boundaries.csv"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
    EXPECT_EQ(text("out/chart.toml").find("\ny = "), std::string::npos);
    EXPECT_NE(text("out/chart.svg").find("beat interval"), std::string::npos);
    EXPECT_NE(text("out/boundaries.csv").find("none"), std::string::npos) << "a change of verdict along the axis";
    const std::string diagram = text("out/diagram.csv");
    EXPECT_NE(diagram.find("going"), std::string::npos);
    // the same command, and the chart it resolved to, give the same numbers
    EXPECT_EQ(chart({"--x", "mu_d=0.2:0.7:11", "--out", "out", "--threads", "1"}).exit_code, 0);
    EXPECT_EQ(text("out/diagram.csv"), diagram);
    const Finished again = run({"chart", "out/chart.toml", "--out", "again", "--threads", "3"}, folder_.path());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(text("again/diagram.csv"), diagram);
    EXPECT_EQ(text("again/chart.csv"), text("out/chart.csv"));
}

TEST_F(ChartOfACase, WhatCannotBeReadIsNamed) {
    const auto refusal = [&](const std::string& x) {
        const Finished done = chart({"--x", x, "--y", "mu_d=0.2:0.6", "--out", "none"});
        EXPECT_EQ(done.exit_code, 2) << x;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "none")) << x;
        return done.err;
    };
    EXPECT_NE(refusal("preload").find("KEY=FROM:TO"), std::string::npos);
    EXPECT_NE(refusal("preload=1:40:3:log:5").find("KEY=FROM:TO"), std::string::npos);
    EXPECT_NE(refusal("preload=40:1").find("smaller end first"), std::string::npos);
    EXPECT_NE(refusal("preload=1:1").find("no axis"), std::string::npos);
    EXPECT_NE(refusal("preload=1 mm:4 mm").find("length"), std::string::npos);
    EXPECT_NE(refusal("preload=1:40:1").find("no number of points"), std::string::npos);
    EXPECT_NE(refusal("preload=1:40:3:lag").find("no scale"), std::string::npos);
    EXPECT_NE(refusal("preloat=1:40").find("Did you mean contact.preload?"), std::string::npos);
    EXPECT_NE(refusal("mu_d=0.1:0.2").find("both"), std::string::npos);
    const Finished bare = run({"chart", "squeal.toml"}, folder_.path());
    EXPECT_EQ(bare.exit_code, 2);
    EXPECT_NE(bare.err.find("--x preload=1:40"), std::string::npos) << bare.err;
}

}  // namespace
