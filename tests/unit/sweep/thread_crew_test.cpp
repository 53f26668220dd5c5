#include "stridor/sweep/thread_crew.hpp"

#include "stridor/sweep/evaluate.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace stridor::sweep {
namespace {

using namespace std::chrono_literals;

TEST(ThreadCrew, ComputesWhatItIsGivenAndIsIdleThen) {
    const Study study = small_study();
    ThreadCrew crew(study, 3, {});
    EXPECT_TRUE(crew.is_idle());
    EXPECT_EQ(crew.seconds_per_run(), 0.0);
    std::vector<std::size_t> runs(cell_count(study));
    std::iota(runs.begin(), runs.end(), std::size_t{0});
    crew.give(runs);
    std::map<std::size_t, Cell> cells;
    while (!crew.is_idle())
        for (IndexedCell& indexed : crew.take(4, Crew::Clock::now() + 1s))
            EXPECT_TRUE(cells.emplace(indexed.index, std::move(indexed.cell)).second) << indexed.index;
    EXPECT_EQ(cells.size(), runs.size());
    integration::Workspace workspace;
    EXPECT_TRUE(same_cell(cells.at(5), evaluate_run(study, 5, {}, workspace).at(0)));
    EXPECT_GT(crew.seconds_per_run(), 0.0);
    EXPECT_FALSE(crew.has_stopped());
    EXPECT_NO_THROW(crew.rethrow());
}

TEST(ThreadCrew, WantsTwoRunsForEachThreadUntilItKnowsHowLongOneTakes) {
    Study study = small_study();
    study.base.run.duration = 1e6;
    study.base.run.early_ending = parameters::EarlyEnding::never;
    ThreadCrew crew(study, 3, {});
    EXPECT_EQ(crew.appetite(100), 6U);
    EXPECT_EQ(crew.appetite(5), 5U);
    crew.give({0, 1, 2, 3, 4, 5});
    EXPECT_LE(crew.appetite(100), 6U);
}

TEST(ThreadCrew, ComesBackAtTheDeadlineWithNothing) {
    Study study = small_study();
    study.base.run.duration = 1e6;
    study.base.run.early_ending = parameters::EarlyEnding::never;
    std::stop_source stop;
    ThreadCrew crew(study, 1, stop.get_token());
    crew.give({0, 1, 2, 3});
    EXPECT_TRUE(crew.take(1, Crew::Clock::now() + 10ms).empty());
    EXPECT_FALSE(crew.is_idle());
    stop.request_stop();
    while (!crew.is_idle())
        EXPECT_TRUE(crew.take(1, Crew::Clock::now() + 1s).empty());
    EXPECT_TRUE(crew.has_stopped());
    EXPECT_EQ(crew.appetite(100), 0U);
}

}  // namespace
}  // namespace stridor::sweep
