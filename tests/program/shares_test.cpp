#include "support/counter_random.hpp"
#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>

using stridor::support::CounterRandom;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::run_and_kill;
using stridor::support::ScratchFolder;
using stridor::support::wait_until;
using stridor::support::write_text;

namespace {

// 64 by 40 points in two directions, blocks of runs of some hundredths of a second each
class SharesOfAChart : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "pair.toml", run({"init", "noise-chart"}).out); }

    std::vector<std::string> chart(const std::string& out, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"chart", "pair.toml", "--out", out, "--threads", "2"};
        for (const char* setting : {"chart.x.points=64", "chart.y.points=40", "run.duration=0.004", "run.window=0.002"})
            arguments.insert(arguments.end(), {"--set", setting});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    // seconds for each cell: it never ends by itself while a test looks at it
    std::vector<std::string> endless(const std::string& share) const {
        return chart("pair", {"--shard", share, "--set", "run.engine=beta_2", "--set", "run.step=2e-6", "--set",
                              "run.duration=4", "--no-early"});
    }

    // a share that is being filled
    std::unique_ptr<Process> at_work(const std::vector<std::string>& share) const {
        auto process = std::make_unique<Process>(Launch{share, folder_.path(), {}, std::nullopt, {}});
        // its signals are noted before it has claimed the store
        const std::string claim = "process = " + std::to_string(process->id()) + "\n";
        const auto is_claimed = [&] {
            std::error_code missing;
            for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "pair/shards", missing))
                if (entry.path().extension() == ".owner" && read_text(entry.path()).find(claim) != std::string::npos)
                    return true;
            return false;
        };
        EXPECT_TRUE(wait_until([&] { return process->handles(SIGTERM) && is_claimed(); }));
        return process;
    }

    Finished done(const std::vector<std::string>& arguments) const { return run(arguments, folder_.path()); }

    std::string text(const std::string& file) const { return read_text(folder_.path() / file); }

    void expect_same_files(const std::string& out, const std::string& other) const {
        for (const char* file : {"/chart.csv", "/boundaries.csv", "/chart.nc", "/chart.svg", "/chart.png"})
            EXPECT_EQ(text(out + file), text(other + file)) << out << file;
    }

    // "1/3" and so on in a random order, all of them
    static std::vector<std::string> shuffled_shares(std::size_t count, CounterRandom& random) {
        std::vector<std::string> shares;
        for (std::size_t index = 0; index < count; ++index)
            shares.insert(shares.begin() + static_cast<std::ptrdiff_t>(random.below(index + 1)),
                          std::to_string(index) + "/" + std::to_string(count));
        return shares;
    }

    ScratchFolder folder_;
};

TEST_F(SharesOfAChart, AreMergedIntoTheBytesOfASingleRun) {
    ASSERT_EQ(done(chart("single")).exit_code, 0);
    const Finished first = done(chart("pair", {"--shard", "0/2"}));
    ASSERT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.out.find("share 0/2 is done: 2560 cells computed into pair/shards/0000-of-0002.sqlite"),
              std::string::npos)
        << first.out;
    EXPECT_NE(first.out.find("stridor merge pair"), std::string::npos) << first.out;
    const Finished early = done({"merge", "pair"});
    EXPECT_EQ(early.exit_code, 4);
    EXPECT_NE(early.out.find("1 of 2 shares, 2560 cells missing\n  1/2: 2560 runs missing (not begun)\n"),
              std::string::npos)
        << early.out;
    const Finished second =
        run(Launch{chart("pair", {"--shard", "auto"}),
                   folder_.path(),
                   "",
                   std::nullopt,
                   {{"SLURM_ARRAY_TASK_ID", "8"}, {"SLURM_ARRAY_TASK_MIN", "7"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}});
    ASSERT_EQ(second.exit_code, 0) << second.err;
    EXPECT_NE(second.out.find("share 1/2 is done: 2560 cells"), std::string::npos) << second.out;
    EXPECT_NE(done(chart("pair", {"--shard", "1/2"})).out.find("share 1/2 is done: 0 cells"), std::string::npos);
    const Finished unmerged = done({"chart", "pair/chart.toml", "--out", "pair"});
    EXPECT_EQ(unmerged.exit_code, 2);
    EXPECT_NE(unmerged.err.find("2560 cells of this chart are in shares that were not merged"), std::string::npos)
        << unmerged.err;
    EXPECT_NE(unmerged.err.find("stridor merge pair"), std::string::npos) << unmerged.err;
    const Finished merged = done({"merge", "pair"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_NE(merged.out.find("complete; to draw it: stridor chart pair/chart.toml --out pair"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "pair/chart.sqlite.owner"));
    const Finished drawn = done({"chart", "pair/chart.toml", "--out", "pair"});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    expect_same_files("pair", "single");
}

TEST_F(SharesOfAChart, OfARefinedOneAreRepeatedUntilTheMergeIsComplete) {
    const std::vector<std::string> refined{"--set", "chart.refine=3", "--set", "chart.starts=rest,stuck"};
    const auto share = [&](const std::string& name) {
        std::vector<std::string> more = refined;
        more.insert(more.end(), {"--shard", name});
        return chart("pair", more);
    };
    ASSERT_EQ(done(chart("single", refined)).exit_code, 0);
    int code = 4;
    int rounds = 0;
    for (; code == 4 && rounds < 10; ++rounds) {
        for (const char* name : {"0/3", "1/3", "2/3"})
            ASSERT_EQ(done(share(name)).exit_code, 0);
        const Finished merged = done({"merge", "pair"});
        code = merged.exit_code;
        if (code == 4) {
            EXPECT_NE(merged.err.find("a refined chart takes its shares and the merge several times"),
                      std::string::npos)
                << merged.err;
        }
    }
    ASSERT_EQ(code, 0);
    EXPECT_GT(rounds, 1);
    ASSERT_EQ(done({"chart", "pair/chart.toml", "--out", "pair"}).exit_code, 0);
    expect_same_files("pair", "single");
}

// STRIDOR_KILLS=20 kills more often
TEST_F(SharesOfAChart, KilledAtRandomInAnyOrderAreMergedIntoTheBytesOfASingleRun) {
    const char* const asked = std::getenv("STRIDOR_KILLS");
    const int kills = asked == nullptr ? 3 : std::atoi(asked);
    const std::vector<std::vector<std::string>> kinds{
        {}, {"--set", "chart.refine=3"}, {"--set", "chart.starts=rest,stuck", "--set", "chart.x.points=32"}};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        CounterRandom random(kind);
        const std::string whole = "single-" + std::to_string(kind);
        const std::string pair = "pair-" + std::to_string(kind);
        ASSERT_EQ(done(chart(whole, kinds[kind])).exit_code, 0);
        int left = kills;
        const auto after_kills = [&](const std::vector<std::string>& arguments) {
            for (; left > 0 && random.one_in(2); --left)
                run_and_kill(arguments, folder_.path(), std::chrono::milliseconds(10 + random.below(90)));
            return done(arguments).exit_code;
        };
        for (int code = 4, rounds = 0; code == 4; ++rounds) {
            ASSERT_LT(rounds, 10);
            // a refined one goes on in another number of shares
            for (const std::string& share : shuffled_shares(1 + random.below(16), random)) {
                std::vector<std::string> more{"--shard", share};
                more.insert(more.end(), kinds[kind].begin(), kinds[kind].end());
                ASSERT_EQ(after_kills(chart(pair, more)), 0) << share;
            }
            code = after_kills({"merge", pair});
        }
        ASSERT_EQ(after_kills({"chart", pair + "/chart.toml", "--out", pair}), 0);
        expect_same_files(pair, whole);
    }
}

TEST_F(SharesOfAChart, AreShownWhileTheyAreFilledAndGoOnAfterASignal) {
    const std::vector<std::string> slow = endless("1/2");
    const std::unique_ptr<Process> process = at_work(slow);
    const Finished status = done({"chart-status", "pair"});
    EXPECT_EQ(status.exit_code, 0) << status.err;
    EXPECT_NE(status.out.find("cells so far, filled by process "), std::string::npos) << status.out;
    EXPECT_NE(status.out.find("1 of 2 shares"), std::string::npos) << status.out;
    EXPECT_NE(status.out.find("  0/2: not begun, 2560 cells missing"), std::string::npos) << status.out;
    EXPECT_EQ(done({"chart-status", "pair", "--lacking", "2"}).out, "0-1\n");
    const auto document = json_of(done({"chart-status", "pair", "--json"}).out);
    EXPECT_EQ(document["schema"], "stridor.chart-status/1");
    EXPECT_EQ(document["cells"]["known"], 5120);
    EXPECT_EQ(document["shares"][0]["standing"], "missing");
    EXPECT_EQ(document["shares"][1]["standing"], "filled");
    EXPECT_EQ(document["shares"][1]["share"], "1/2");
    EXPECT_TRUE(document["shares"][1]["owner"]["process"].is_number());
    const Finished second = done(slow);
    EXPECT_EQ(second.exit_code, 5) << "two at one share";
    EXPECT_NE(second.err.find("is in use"), std::string::npos) << second.err;
    process->send(SIGTERM);
    const Finished stopped = process->wait();
    EXPECT_EQ(stopped.exit_code, 4);
    EXPECT_NE(stopped.err.find("Run the same command again to go on"), std::string::npos) << stopped.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "pair/shards/0001-of-0002.sqlite.owner"));
}

TEST_F(SharesOfAChart, OfADeadProcessAreTakenOverAndItIsSaid) {
    const std::vector<std::string> slow = endless("0/2");
    const std::unique_ptr<Process> first = at_work(slow);
    first->send(SIGKILL);
    first->wait();
    const std::unique_ptr<Process> second = at_work(slow);
    second->send(SIGTERM);
    const Finished again = second->wait();
    EXPECT_NE(again.err.find("note: took over the store pair/shards/0000-of-0002.sqlite from process "),
              std::string::npos)
        << again.err;
}

TEST_F(SharesOfAChart, OfAnotherChartAreRefused) {
    ASSERT_EQ(done(chart("pair", {"--shard", "0/2"})).exit_code, 0);
    const Finished other = done(chart("pair", {"--shard", "1/2", "--set", "mu_s=0.9"}));
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("the folder pair holds another chart"), std::string::npos) << other.err;
}

TEST_F(SharesOfAChart, AreNamedOrTakenFromAnArray) {
    const Finished none = done(chart("pair", {"--shard", "auto"}));
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("SLURM_ARRAY_TASK_ID is not set"), std::string::npos) << none.err;
    EXPECT_EQ(done(chart("pair", {"--shard", "2/2"})).exit_code, 2);
    EXPECT_EQ(done({"merge", "pair"}).exit_code, 5) << "there is no chart";
    EXPECT_EQ(done({"chart-status", "pair"}).exit_code, 5);
}

TEST_F(SharesOfAChart, ForSlurmIsAScriptAndNothingIsComputed) {
    const Finished printed = done(chart("pair", {"--slurm", "16", "--time", "2:00:00"}));
    ASSERT_EQ(printed.exit_code, 0) << printed.err;
    EXPECT_TRUE(printed.out.starts_with("#!/bin/bash\n#SBATCH "));
    EXPECT_NE(printed.out.find("shares=16\nthreads=2\n"), std::string::npos);
    EXPECT_NE(text("pair/chart.toml").find("points = 40"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "pair/chart.sqlite"));
    EXPECT_EQ(done(chart("pair", {"--slurm", "16", "--time", "soon"})).exit_code, 2);
    EXPECT_EQ(done(chart("pair", {"--time", "2:00:00"})).exit_code, 2) << "of what?";
}

}  // namespace
