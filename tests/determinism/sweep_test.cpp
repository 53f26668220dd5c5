// A sweep's cells depend on its study alone: not on threads, stops or kills.

#include "determinism/swept_study.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/run.hpp"
#include "support/process.hpp"
#include "support/wait.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>

namespace stridor::sweep {
namespace {

using support::Finished;
using support::Launch;
using support::Process;

// a store in which so many batches may be written until a stop is requested
class ImpatientKeeper final : public CellKeeper {
public:
    ImpatientKeeper(Store& store, int batches) : store_(store), left_(batches) {}

    std::stop_token token() const { return source_.get_token(); }

    std::string name() const override { return store_.name(); }
    std::vector<bool> stored() override { return store_.stored(); }
    Counts counts() override { return store_.counts(); }
    void write(std::span<const IndexedCell> cells) override {
        // before the disk is waited for: the threads go on meanwhile, and might come to the end of the study
        if (--left_ <= 0) source_.request_stop();
        store_.write(cells);
    }
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override {
        store_.visit(first, last, use);
    }

private:
    Store& store_;
    int left_;
    std::stop_source source_;
};

// by refinement: a complete chart and a refined one
class Sweep : public testing::TestWithParam<int> {
protected:
    // a sweep that nobody disturbs
    std::vector<Cell> undisturbed(int threads) {
        Store store(folder_ / ("undisturbed-" + std::to_string(threads)), study_);
        RunOptions options;
        options.crew = crew::thread_crews(threads);
        EXPECT_EQ(run(study_, store, options).ending, SweepEnding::completed);
        return all_cells(load(study_, store));
    }

    // every cell that a disturbed sweep left is the right one
    void expect_part_of(const std::vector<Cell>& cells, const std::filesystem::path& file) {
        Store store(file, study_);
        for (const IndexedCell& indexed : store.read())
            EXPECT_TRUE(same_cell(indexed.cell, cells[indexed.index])) << indexed.index;
    }

    Launch child(int threads) const {
        return {{(folder_ / "disturbed").string(), std::to_string(threads), std::to_string(GetParam())},
                {},
                "",
                std::nullopt,
                {}};
    }

    ScratchFolder folder_;
    Study study_ = swept_study(GetParam());
};

TEST_P(Sweep, HasTheSameBitsForEveryNumberOfThreads) {
    const std::vector<Cell> cells = undisturbed(1);
    EXPECT_TRUE(same_cells(cells, undisturbed(2)));
    EXPECT_TRUE(same_cells(cells, undisturbed(4)));
    // the study is worth the test: it meets several categories
    std::set<classification::Category> met;
    for (const Cell& cell : cells)
        met.insert(cell.category);
    EXPECT_GE(met.size(), 3U);
}

// cells one by one, in an order far from theirs, by every instruction set of this machine
TEST_P(Sweep, HasTheSameBitsInAnyOrderByAnyInstructionSet) {
    const std::vector<Cell> cells = undisturbed(2);
    const std::size_t stride = cells.size() / 3 + 1;
    for (const auto set : integration::available_instruction_sets()) {
        integration::Workspace workspace;
        workspace.instruction_set = set;
        for (std::size_t begin = 0; begin < stride; ++begin)
            for (std::size_t index = begin; index < cells.size(); index += stride) {
                // a refined sweep has computed some of them only
                if (std::isnan(figure_of(cells[index], "slip"))) continue;
                const Cell alone = evaluate_run(study_, index, {}, workspace).at(0);
                ASSERT_TRUE(same_cell(alone, cells[index])) << index << " by " << static_cast<int>(set);
            }
    }
}

TEST_P(Sweep, HasTheSameBitsHoweverOftenItWasStopped) {
    const std::vector<Cell> cells = undisturbed(2);
    Store store(folder_ / "disturbed", study_);
    SweepEnding ending = SweepEnding::stopped;
    int stops = 0;
    while (ending == SweepEnding::stopped) {
        ImpatientKeeper keeper(store, 1 + stops / 3);
        RunOptions options;
        options.crew = crew::thread_crews(1 + stops % 3);
        options.stop = keeper.token();
        options.cells_per_commit = 4;
        ending = run(study_, keeper, options).ending;
        if (ending == SweepEnding::stopped) ++stops;
    }
    EXPECT_GE(stops, 3);
    EXPECT_TRUE(same_cells(all_cells(load(study_, store)), cells));
}

TEST_P(Sweep, HasTheSameBitsHoweverOftenItWasKilled) {
    const std::vector<Cell> cells = undisturbed(2);
    int kills = 0;
    // while the process starts, while the store is opened, after a few batches of cells
    for (const std::size_t marks : {0U, 1U, 2U, 2U, 3U, 4U, 6U, 2U, 5U, 3U}) {
        Process process(child(1 + kills % 2));
        EXPECT_TRUE(support::wait_until([&] { return process.err().size() >= marks || !process.is_running(); }));
        process.send(SIGKILL);
        if (process.wait().signal == SIGKILL) ++kills;
        expect_part_of(cells, folder_ / "disturbed");
    }
    EXPECT_GE(kills, 3);
    const Finished last = support::run(child(2));
    EXPECT_EQ(last.exit_code, 0) << last.err;
    Store store(folder_ / "disturbed", study_);
    EXPECT_TRUE(same_cells(all_cells(load(study_, store)), cells));
}

TEST_P(Sweep, RefusesTheStoreThatAnotherProcessIsFilling) {
    const Store store(folder_ / "disturbed", study_);
    const Finished refused = support::run(child(1));
    EXPECT_EQ(refused.exit_code, base::exit_code(ErrorKind::io));
    EXPECT_NE(refused.err.find("is in use (another process has it open)"), std::string::npos) << refused.err;
}

// at a barrier: two pipes, of which the children inherit one end each
class Barrier {
public:
    Barrier() {
        if (pipe(ready_.data()) != 0 || pipe(go_.data()) != 0) throw std::runtime_error("no pipe");
        for (const int ours : {ready_[0], go_[1]})
            fcntl(ours, F_SETFD, FD_CLOEXEC);
    }
    ~Barrier() {
        for (const int end : {ready_[0], ready_[1], go_[0], go_[1]})
            if (end >= 0) close(end);
    }
    Barrier(const Barrier&) = delete;
    Barrier& operator=(const Barrier&) = delete;

    std::vector<std::string> arguments() const { return {std::to_string(ready_[1]), std::to_string(go_[0])}; }

    void release(int children) {
        for (char byte = 0; children > 0; --children)
            ASSERT_EQ(read(ready_[0], &byte, 1), 1);
        close(std::exchange(go_[1], -1));
    }

private:
    std::array<int, 2> ready_{};
    std::array<int, 2> go_{};
};

// the others find the store in use, or whole if the one was quick
TEST_P(Sweep, IsComputedByExactlyOneOfSeveralThatBeginAtOnce) {
    const std::vector<Cell> cells = undisturbed(2);
    const auto total = static_cast<std::size_t>(std::count_if(
        cells.begin(), cells.end(), [](const Cell& cell) { return !std::isnan(figure_of(cell, "slip")); }));
    const int rounds = support::effort(50, 5) / (GetParam() == 0 ? 1 : 5);
    for (int round = 0; round < rounds; ++round) {
        const std::filesystem::path file = folder_ / ("begun-" + std::to_string(round));
        Barrier barrier;
        Launch launch = child(1);
        launch.arguments[0] = file.string();
        for (const std::string& argument : barrier.arguments())
            launch.arguments.push_back(argument);
        const int starters = round % 5 == 4 ? 4 : 2;
        std::vector<std::unique_ptr<Process>> processes;
        for (int k = 0; k < starters; ++k)
            processes.push_back(std::make_unique<Process>(launch));
        barrier.release(starters);
        int computing = 0;
        for (const std::unique_ptr<Process>& process : processes) {
            const Finished finished = process->wait();
            if (finished.exit_code == 0 && finished.out != "0\n") {
                ++computing;
                EXPECT_GE(std::stoul(finished.out), total);
            }
            if (finished.exit_code == 0) continue;
            EXPECT_EQ(finished.exit_code, base::exit_code(ErrorKind::io));
            EXPECT_NE(finished.err.find("is in use (another process has it open)"), std::string::npos) << finished.err;
        }
        ASSERT_EQ(computing, 1) << "round " << round;
        Store store(file, study_);
        ASSERT_TRUE(same_cells(all_cells(load(study_, store)), cells)) << "round " << round;
    }
}

INSTANTIATE_TEST_SUITE_P(Refined, Sweep, testing::Values(0, 3));

}  // namespace
}  // namespace stridor::sweep
