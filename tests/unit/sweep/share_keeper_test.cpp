#include "stridor/sweep/store/share_keeper.hpp"

#include "stridor/sweep/run.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace stridor::sweep {
namespace {

using support::thrown_by;

Cell cell_with(double value, classification::Category category) {
    Cell cell;
    cell.status = Status::done;
    cell.category = category;
    set_figure(cell, cell_figure("slip"), value);
    return cell;
}

class ShareKeeperOf : public testing::Test {
protected:
    std::vector<std::size_t> indices(CellKeeper& keeper, std::size_t first, std::size_t last) {
        std::vector<std::size_t> found;
        keeper.visit(first, last, [&](const IndexedCell& cell) { found.push_back(cell.index); });
        return found;
    }

    void merge(const std::vector<std::size_t>& cells) {
        Store store(merged_, study_);
        for (const std::size_t index : cells)
            store.write(std::vector<IndexedCell>{{index, cell_with(1.0, classification::Category::squeal)}});
    }

    ScratchFolder folder_;
    std::filesystem::path own_ = folder_ / "own.sqlite";
    std::filesystem::path merged_ = folder_ / "chart.sqlite";
    Study study_ = small_study();
};

TEST_F(ShareKeeperOf, AChartThatWasNeverMergedHasItsOwnCellsAlone) {
    ShareKeeper keeper(own_, merged_, study_);
    keeper.write(std::vector<IndexedCell>{{5, cell_with(1.0, classification::Category::creak)}});
    EXPECT_EQ(indices(keeper, 0, cell_count(study_)), std::vector<std::size_t>{5});
    EXPECT_EQ(keeper.counts().statuses[0], 1U);
    EXPECT_FALSE(std::filesystem::exists(merged_)) << "reading makes no store";
}

TEST_F(ShareKeeperOf, AMergedChartShowsBothInOrderAndWritesIntoItsOwn) {
    merge({1, 5, 7, 20});
    {
        ShareKeeper keeper(own_, merged_, study_);
        keeper.write(std::vector<IndexedCell>{{6, cell_with(2.0, classification::Category::creak)},
                                              {0, cell_with(2.0, classification::Category::creak)},
                                              {7, cell_with(1.0, classification::Category::squeal)}});
        EXPECT_EQ(indices(keeper, 0, cell_count(study_)), (std::vector<std::size_t>{0, 1, 5, 6, 7, 20}));
        EXPECT_EQ(indices(keeper, 1, 7), (std::vector<std::size_t>{1, 5, 6}));
        const std::vector<bool> stored = keeper.stored();
        EXPECT_EQ(std::count(stored.begin(), stored.end(), true), 6);
        const Counts counts = keeper.counts();
        EXPECT_EQ(counts.statuses[static_cast<std::size_t>(Status::done)], 6U) << "the one in both counts once";
        EXPECT_EQ(counts.categories[static_cast<std::size_t>(classification::Category::creak)], 2U);
    }
    EXPECT_EQ(Store(merged_, study_).read().size(), 4U);
    EXPECT_EQ(Store(own_, study_).read().size(), 3U);
}

TEST_F(ShareKeeperOf, SeveralSharesMayReadWhatWasMerged) {
    merge({1});
    ShareKeeper one(own_, merged_, study_);
    ShareKeeper other(folder_ / "other.sqlite", merged_, study_);
    EXPECT_EQ(indices(one, 0, 24), indices(other, 0, 24));
}

TEST_F(ShareKeeperOf, RefusesWhatSomebodyFills) {
    const Store filled(merged_, study_);
    EXPECT_TRUE(thrown_by([&] { ShareKeeper(own_, merged_, study_); }).says("chart.sqlite is in use"));
}

TEST_F(ShareKeeperOf, TakesAStoreThatDiedBeforeItsTablesForEmpty) {
    std::ofstream(merged_).close();
    ShareKeeper keeper(own_, merged_, study_);
    EXPECT_TRUE(indices(keeper, 0, 24).empty());
    EXPECT_EQ(keeper.counts().statuses, Counts{}.statuses);
    EXPECT_EQ(keeper.stored(), std::vector<bool>(24));
}

// who computes what is known of a plain chart, whoever computes it
TEST_F(ShareKeeperOf, ASharesRunComputesWhatIsMissingOfItAndNothingElse) {
    study_.x.points = 64;
    study_.y.points = 20;
    study_.base.run.duration = 0.002;
    study_.base.run.window = 0.001;
    // blocks of 80 runs
    merge({0, 1, 2, 85, 2050});
    RunOptions options;
    options.share = {1, 2};
    ShareKeeper keeper(own_, merged_, study_);
    const RunReport report = run(study_, keeper, options);
    EXPECT_EQ(report.ending, SweepEnding::completed);
    EXPECT_EQ(report.computed, 1280U - 2U) << "its half, without what was merged of it";
    EXPECT_EQ(run(study_, keeper, options).computed, 0U);
    for (const std::size_t index : indices(keeper, 0, cell_count(study_)))
        EXPECT_TRUE(is_in(options.share, study_, index) || index < 3) << index;
}

}  // namespace
}  // namespace stridor::sweep
