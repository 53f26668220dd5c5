#include "stridor/sweep/store/chart_state.hpp"

#include "stridor/storage/owner_draft.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/merge.hpp"
#include "stridor/sweep/store/share.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace stridor::sweep {
namespace {

class StateOf : public testing::Test {
protected:
    StateOf() {
        std::filesystem::create_directories(shares_folder(folder_.path()));
        study_.x.points = 64;
        study_.y.points = 40;
    }

    // the first cells of a share, so many
    void fill(const Share& share, std::size_t wanted) {
        Store store(share_file(folder_.path(), share), study_);
        std::vector<IndexedCell> cells;
        for (std::size_t index = 0; index < cell_count(study_) && cells.size() < wanted; ++index)
            if (is_in(share, study_, index)) cells.push_back({index, Cell{}});
        store.write(cells);
    }

    // how many cells a share has
    std::size_t cells_of(const Share& share) const {
        std::size_t cells = 0;
        for (std::size_t index = 0; index < cell_count(study_); ++index)
            cells += is_in(share, study_, index) ? 1 : 0;
        return cells;
    }

    ChartState state() const { return chart_state(study_, folder_.path()); }

    ScratchFolder folder_;
    Study study_ = small_study();
};

TEST_F(StateOf, AChartThatWasNotBegunLacksAll) {
    const ChartState none = state();
    EXPECT_EQ(none.done, 0U);
    EXPECT_EQ(none.total, 5120U);
    EXPECT_FALSE(none.is_merged);
    EXPECT_TRUE(none.shares.empty());
    EXPECT_EQ(none.chart.standing, StoreStanding::missing);
}

TEST_F(StateOf, SharesNamesThoseThatLackCells) {
    fill({0, 3}, 2048);
    fill({2, 3}, 100);
    const ChartState part = state();
    EXPECT_EQ(part.done, cells_of({0, 3}) + 100U);
    EXPECT_EQ(part.total, 5120U);
    ASSERT_EQ(part.shares.size(), 3U);
    EXPECT_EQ(part.shares[0].standing, StoreStanding::complete);
    EXPECT_EQ(part.shares[1].standing, StoreStanding::missing);
    EXPECT_EQ(part.shares[1].missing, cells_of({1, 3}));
    EXPECT_EQ(part.shares[2].standing, StoreStanding::partial);
    EXPECT_EQ(part.shares[2].cells, 100U);
    EXPECT_EQ(part.shares[2].missing, cells_of({2, 3}) - 100U);
}

TEST_F(StateOf, AMergedChartNeedsNoShares) {
    for (const std::size_t index : {0U, 1U})
        fill({index, 2}, 5120);
    EXPECT_FALSE(state().is_merged) << "not before the merge";
    EXPECT_EQ(state().done, 5120U);
    merge(study_, folder_.path());
    std::filesystem::remove_all(shares_folder(folder_.path()));
    const ChartState merged = state();
    EXPECT_TRUE(merged.is_merged);
    EXPECT_EQ(merged.done, 5120U);
    EXPECT_EQ(merged.chart.standing, StoreStanding::complete);
}

TEST_F(StateOf, AChartThatWasStoppedSaysHowMuchItsStoreLacks) {
    {
        Store store(folder_ / "chart.sqlite", study_);
        std::vector<IndexedCell> cells;
        for (std::size_t index = 0; index < 100; ++index)
            cells.push_back({index, Cell{}});
        store.write(cells);
    }
    const ChartState stopped = state();
    EXPECT_EQ(stopped.chart.standing, StoreStanding::partial);
    EXPECT_EQ(stopped.chart.cells, 100U);
    EXPECT_EQ(stopped.chart.missing, 5020U);
}

TEST_F(StateOf, AStoreThatIsFilledIsToldByItsOwnerAndNotOpened) {
    fill({0, 2}, 3072);
    const std::filesystem::path file = share_file(folder_.path(), {1, 2});
    std::ofstream(file) << "half of a page";
    std::ofstream(storage::owner_file_of(file)) << storage::owner_text({"another-host", 17, "4711", "m", 900});
    const ChartState part = state();
    ASSERT_EQ(part.shares.size(), 2U);
    EXPECT_EQ(part.shares[1].standing, StoreStanding::filled);
    EXPECT_EQ(part.shares[1].cells, 900U);
    EXPECT_EQ(part.shares[1].owner->owner.job, "4711");
    EXPECT_EQ(part.done, 2560U + 900U);
}

TEST_F(StateOf, ADamagedStoreIsSaidToBe) {
    fill({0, 2}, 3072);
    std::ofstream(share_file(folder_.path(), {1, 2})) << "this is no store, and longer than nothing";
    const ChartState part = state();
    EXPECT_EQ(part.shares[1].standing, StoreStanding::unreadable);
    EXPECT_NE(part.shares[1].problem.find("0001-of-0002.sqlite"), std::string::npos) << part.shares[1].problem;
    EXPECT_EQ(part.done, 2560U);
}

TEST_F(StateOf, ARefinedChartKnowsOnlyWhatIsNeededSoFar) {
    study_.refine = 3;
    const ChartState begun = state();
    EXPECT_EQ(begun.done, 0U);
    EXPECT_EQ(begun.total, 2U * 9U * 6U) << "the base grid in both directions";
}

}  // namespace
}  // namespace stridor::sweep
