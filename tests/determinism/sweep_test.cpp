// A sweep's cells depend on its study alone: not on threads, stops or kills.

#include "determinism/swept_study.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/run.hpp"
#include "support/process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <set>
#include <string>
#include <thread>

namespace stridor::sweep {
namespace {

using support::Finished;
using support::Launch;
using support::Process;

void pause(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

// by refinement: a complete chart and a refined one
class Sweep : public testing::TestWithParam<int> {
protected:
    // a sweep that nobody disturbs
    std::vector<Cell> undisturbed(int threads) {
        Store store(folder_ / ("undisturbed-" + std::to_string(threads)), study_);
        RunOptions options;
        options.threads = threads;
        EXPECT_EQ(run(study_, store, options).ending, Ending::completed);
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
                if (std::isnan(cells[index].slip)) continue;
                const Cell alone = evaluate_run(study_, index, {}, workspace).at(0);
                ASSERT_TRUE(same_cell(alone, cells[index])) << index << " by " << static_cast<int>(set);
            }
    }
}

TEST_P(Sweep, HasTheSameBitsHoweverOftenItWasStopped) {
    const std::vector<Cell> cells = undisturbed(2);
    Store store(folder_ / "disturbed", study_);
    Ending ending = Ending::stopped;
    int stops = 0;
    // each attempt gets more time, so that the last one ends on any machine
    for (int wait = 5; ending == Ending::stopped; wait += 5) {
        std::stop_source source;
        RunOptions options;
        options.threads = 1 + stops % 3;
        options.stop = source.get_token();
        const std::jthread impatient([&, wait] {
            pause(wait);
            source.request_stop();
        });
        ending = run(study_, store, options).ending;
        if (ending == Ending::stopped) ++stops;
    }
    EXPECT_GE(stops, 1);
    EXPECT_TRUE(same_cells(all_cells(load(study_, store)), cells));
}

TEST_P(Sweep, HasTheSameBitsHoweverOftenItWasKilled) {
    const std::vector<Cell> cells = undisturbed(2);
    int kills = 0;
    // irregular moments: while the process starts, the store is made, cells are written
    for (const int wait : {1, 3, 5, 8, 11, 15, 20, 26, 33, 41}) {
        Process process(child(1 + kills % 2));
        pause(wait);
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

INSTANTIATE_TEST_SUITE_P(Refined, Sweep, testing::Values(0, 3));

}  // namespace
}  // namespace stridor::sweep
