// A search and an evaluation that were killed go on, and end with the same bytes.

#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>

using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::Process;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::wait_until;
using stridor::support::write_text;

namespace {

class KeptResults : public testing::Test {
protected:
    void SetUp() override { write_text(folder_ / "pair.toml", run({"init", "noise-chart"}).out); }

    Launch launch(const std::vector<std::string>& arguments, const std::string& cache) const {
        return Launch{
            arguments, folder_.path(), {}, std::nullopt, {{"XDG_CACHE_HOME", (folder_.path() / cache).string()}}};
    }

    Finished finish(const std::vector<std::string>& arguments, const std::string& cache) const {
        return Process(launch(arguments, cache)).wait();
    }

    // killed several times, each time later than before
    void kill(const std::vector<std::string>& arguments, const std::string& cache) const {
        for (const int wait : {300, 600, 900}) {
            Process process(launch(arguments, cache));
            process.ends_within(std::chrono::milliseconds(wait));
            process.send(SIGKILL);
            process.wait();
        }
    }

    bool is_empty(const std::string& cache) const {
        return std::filesystem::is_empty(folder_.path() / cache / "stridor");
    }

    void expect_resumed(const std::vector<std::string>& arguments) const {
        const Finished whole = finish(arguments, "whole");
        ASSERT_EQ(whole.exit_code, 0) << whole.err;
        EXPECT_TRUE(is_empty("whole")) << "nothing is left behind";
        kill(arguments, "killed");
        const Finished last = finish(arguments, "killed");
        ASSERT_EQ(last.exit_code, 0) << last.err;
        EXPECT_EQ(last.out, whole.out);
        EXPECT_TRUE(is_empty("killed"));
    }

    ScratchFolder folder_;
};

const std::vector<std::string> points{"--set", "chart.x.points=6", "--set", "chart.y.points=6"};

std::vector<std::string> with_points(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), points.begin(), points.end());
    return arguments;
}

TEST_F(KeptResults, AKilledEvaluationEndsWithTheSameBytes) {
    expect_resumed(with_points({"evaluate", "pair.toml", "--threads", "1", "--perturb-every", "20", "--json"}));
}

TEST_F(KeptResults, AKilledEvaluationOfRecordingsEndsWithTheSameBytes) {
    ASSERT_EQ(run({"listen", "pair.toml", "--cell", "x=20 N,y=0.6", "--direction", "going", "--out", "cell.wav"},
                  folder_.path())
                  .exit_code,
              0);
    std::string table = "file,expected\n";
    for (int k = 0; k < 60; ++k) {
        const std::string name = "clip" + std::to_string(k) + ".wav";
        std::filesystem::copy_file(folder_.path() / "cell.wav", folder_.path() / name);
        table += name + ",squeal\n";
    }
    write_text(folder_ / "expected.csv", table);
    expect_resumed({"evaluate", "--recordings", folder_.path().string(), "--json"});
}

TEST_F(KeptResults, AKilledSearchEndsWithTheSameBytes) {
    ASSERT_EQ(run({"listen", "pair.toml", "--cell", "x=20 N,y=0.6", "--direction", "going", "--out", "cell.wav"},
                  folder_.path())
                  .exit_code,
              0);
    expect_resumed(with_points({"match", "cell.wav", "--chart", "pair.toml", "--every", "--threads", "1", "--json"}));
}

TEST_F(KeptResults, AnInterruptSaysThatTheSameCommandGoesOn) {
    // far more than is heard until the signal comes
    Process process(launch({"evaluate", "pair.toml", "--threads", "1", "--perturb-every", "1"}, "cache"));
    const std::filesystem::path cache = folder_.path() / "cache" / "stridor";
    ASSERT_TRUE(wait_until([&] {
        return std::filesystem::exists(cache) && !std::filesystem::is_empty(cache) && process.handles(SIGINT);
    }));
    process.send(SIGINT);
    const Finished stopped = process.wait();
    ASSERT_EQ(stopped.exit_code, 4) << stopped.err;
    EXPECT_NE(stopped.err.find("same command again to go on"), std::string::npos) << stopped.err;
    EXPECT_FALSE(is_empty("cache"));
    // other values are another computation, which neither uses nor removes it
    const Finished other =
        finish({"evaluate", "pair.toml", "--set", "chart.x.points=2", "--set", "chart.y.points=2"}, "cache");
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(other.err.find("goes on from"), std::string::npos) << other.err;
    EXPECT_FALSE(is_empty("cache"));
}

TEST_F(KeptResults, WithoutAPlaceTheWorkIsDoneAllTheSame) {
    write_text(folder_ / "file", "a file where a folder should be");
    const Finished done =
        finish({"evaluate", "pair.toml", "--set", "chart.x.points=2", "--set", "chart.y.points=2"}, "file");
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.err.find("nothing is kept of this run"), std::string::npos) << done.err;
}

}  // namespace
