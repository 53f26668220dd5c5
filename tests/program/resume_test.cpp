#include "support/effort.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <initializer_list>

using stridor::support::effort;
using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::run_and_kill;
using stridor::support::ScratchFolder;
using stridor::support::wait_until;
using stridor::support::write_text;

namespace {

// 8 by 8 cells in two directions (4 by 4 and longer steps in checked builds), about a second of work on one core
std::vector<std::string> sweep(const std::string& out, const std::string& threads) {
    return {"chart",     "chart.toml",
            "--out",     out,
            "--threads", threads,
            "--set",     effort("chart.x.points=8", "chart.x.points=4"),
            "--set",     effort("chart.y.points=8", "chart.y.points=4"),
            "--set",     "run.duration=0.2",
            "--set",     "run.window=0.1",
            "--set",     "run.engine=beta_2",
            "--set",     effort("run.step=2e-6", "run.step=8e-6")};
}

class Resume : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "chart.toml", run({"init", "noise-chart"}).out); }

    std::string csv(const std::string& out) const { return read_text(folder_.path() / out / "chart.csv"); }

    // arguments(OUT, THREADS) compute a chart that is there as a whole in "whole": killed after so many ms each, on one
    // thread and on two in turn, and done at last, it ends with the same bytes
    template <typename Arguments>
    void expect_same_after_kills(const Arguments& arguments, std::initializer_list<int> waits) {
        int kills = 0;
        for (const int wait : waits)
            run_and_kill(arguments("killed", kills++ % 2 == 0 ? "1" : "2"), folder_.path(),
                         std::chrono::milliseconds(wait));
        const Finished last = run(arguments("killed", "1"), folder_.path());
        ASSERT_EQ(last.exit_code, 0) << last.err;
        EXPECT_EQ(csv("killed"), csv("whole"));
    }

    ScratchFolder folder_;
};

}  // namespace

TEST_F(Resume, AKilledChartOfAnOwnStructureEndsWithTheSameBytes) {
    write_text(folder_ / "string.toml", run({"init", "string"}).out);
    const auto chart = [](const std::string& out, const std::string& threads) {
        return std::vector<std::string>{"chart",     "string.toml",
                                        "--x",       "preload=0.2:2:4",
                                        "--y",       "mu_d=0.2:0.4:4",
                                        "--set",     "run.duration=0.1",
                                        "--set",     "run.window=0.05",
                                        "--out",     out,
                                        "--threads", threads};
    };
    ASSERT_EQ(run(chart("whole", "2"), folder_.path()).exit_code, 0);
    ASSERT_FALSE(csv("whole").empty());
    expect_same_after_kills(chart, {60, 120, 200});
}

TEST_F(Resume, AKilledSweepEndsWithTheSameBytesAsAnUninterruptedOne) {
    ASSERT_EQ(run(sweep("whole", "2"), folder_.path()).exit_code, 0);
    ASSERT_FALSE(csv("whole").empty());
    // ten kills after fixed, irregular waits: start-up, first cells, late cells,
    // whatever the machine's speed makes of them
    expect_same_after_kills(sweep, {3, 11, 23, 37, 61, 83, 127, 151, 197, 251});
}

TEST_F(Resume, AKilledRefinedSweepFromSeveralStartsEndsWithTheSameBytes) {
    const auto refined = [](const std::string& out, const std::string& threads) {
        std::vector<std::string> arguments = sweep(out, threads);
        for (const char* setting :
             {effort("chart.x.points=17", "chart.x.points=9"), effort("chart.y.points=17", "chart.y.points=9"),
              effort("chart.refine=3", "chart.refine=2"), "chart.starts=rest,stuck", "run.duration=0.1",
              "run.window=0.05"})
            arguments.insert(arguments.end(), {"--set", setting});
        return arguments;
    };
    const Finished whole = run(refined("whole", "2"), folder_.path());
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_NE(whole.out.find(" of them computed"), std::string::npos) << whole.out;
    EXPECT_NE(whole.out.find("from 2 starts: agree "), std::string::npos) << whole.out;
    EXPECT_NE(csv("whole").find(",inferred,"), std::string::npos);
    expect_same_after_kills(refined, {40, 90, 160, 250, 350});
    EXPECT_EQ(read_text(folder_.path() / "killed" / "boundaries.csv"),
              read_text(folder_.path() / "whole" / "boundaries.csv"));
}

TEST_F(Resume, TheNumberOfThreadsChangesNoByte) {
    ASSERT_EQ(run(sweep("one", "1"), folder_.path()).exit_code, 0);
    ASSERT_EQ(run(sweep("four", "4"), folder_.path()).exit_code, 0);
    EXPECT_EQ(csv("one"), csv("four"));
}

TEST_F(Resume, AnInterruptStopsWithinASecondSaysHowToGoOnAndResumes) {
    for (const int signal : {SIGINT, SIGTERM}) {
        std::vector<std::string> slow = sweep("stopped", "2");
        slow.insert(slow.end(), {"--set", "run.duration=4", "--set", "chart.x.points=4", "--set", "chart.y.points=4"});
        Process process(Launch{slow, folder_.path(), {}, std::nullopt, {}});
        ASSERT_TRUE(wait_until([&] { return process.handles(signal); }));
        process.send(signal);
        EXPECT_TRUE(process.ends_within(std::chrono::seconds(20)));
        const Finished finished = process.wait();
        EXPECT_EQ(finished.exit_code, 4) << finished.err;
        EXPECT_NE(finished.err.find("same command again"), std::string::npos) << finished.err;
    }
}

TEST_F(Resume, AFinishedSweepRunAgainComputesNothingAndGivesTheSameFiles) {
    ASSERT_EQ(run(sweep("out", "2"), folder_.path()).exit_code, 0);
    const std::string first = csv("out");
    const Finished again = run(sweep("out", "2"), folder_.path());
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_EQ(csv("out"), first);
}
