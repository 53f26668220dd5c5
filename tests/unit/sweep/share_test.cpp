#include "stridor/sweep/store/share.hpp"

#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/share_keeper.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

namespace stridor::sweep {
namespace {

using support::thrown_by;

// `points` by `points` in two directions, each with runs of its own
Study square(int points) {
    Study study = small_study();
    study.x.points = points;
    study.y.points = points;
    return study;
}

TEST(Share, IsTheWholeChartUnlessToldOtherwise) {
    for (const std::size_t run : {0U, 1U, 1023U, 1024U, 5000U})
        EXPECT_TRUE(is_in({}, square(100), run)) << run;
}

TEST(Share, DealsEveryRunToExactlyOneInBlocksOfNeighbours) {
    for (const std::size_t count : {1U, 2U, 5U, 16U, 300U}) {
        const Study study = square(100);
        const std::size_t block = runs_per_block(study, count);
        for (std::size_t run = 0; run < cell_count(study); run += 7) {
            std::vector<std::size_t> owners;
            for (std::size_t index = 0; index < count; ++index)
                if (is_in({index, count}, study, run)) owners.push_back(index);
            ASSERT_EQ(owners, std::vector<std::size_t>{run / block % count}) << run << " of " << count;
        }
    }
}

TEST(Share, HasBlocksAllOverTheChartBeItSmallOrLarge) {
    // 3200 runs, 16 shares: sixteen blocks of 12 for each
    EXPECT_EQ(runs_per_block(square(40), 16), 12U);
    EXPECT_EQ(runs_per_block(square(3), 16), 1U);
    EXPECT_EQ(runs_per_block(square(4000), 16), 1024U);
    // one run gives both directions
    Study both = square(40);
    both.base.drive.kind = parameters::DriveKind::sinusoidal;
    EXPECT_EQ(runs_per_block(both, 16), 6U);
}

TEST(Share, ReadsWhatItWrites) {
    for (const Share share : {Share{0, 1}, Share{3, 16}, Share{15, 16}, Share{9998, 9999}})
        EXPECT_EQ(read_share(text_of(share)), share);
    EXPECT_EQ(text_of({3, 16}), "3/16");
    EXPECT_EQ(file_name_of({3, 16}), "0003-of-0016");
}

TEST(Share, RefusesWhatIsNone) {
    for (const char* text : {"", "3", "/", "3/", "/16", "-1/16", "3/16 ", "+3/16", "3 / 16", "a/b", "1.5/16", "3/16/2"})
        EXPECT_TRUE(thrown_by([&] { read_share(text); }).says("a share is INDEX/COUNT, counted from 0")) << text;
    EXPECT_TRUE(thrown_by([] { read_share("16/16"); }).says("16 shares count from 0/16 to 15/16"));
    EXPECT_TRUE(thrown_by([] { read_share("1/1"); }).says("the only one is 0/1"));
    EXPECT_TRUE(thrown_by([] { read_share("0/0"); }).says("1 to 9999 shares"));
    EXPECT_TRUE(thrown_by([] { read_share("0/10000"); }).says("1 to 9999 shares"));
    EXPECT_EQ(thrown_by([] { read_share("99999999999999999999999/4"); }).kind, ErrorKind::input);
}

TEST(Share, OfAnArrayCountsFromTheArraysFirstTask) {
    EXPECT_EQ(share_of({"3", "0", "16"}), (Share{3, 16}));
    EXPECT_EQ(share_of({"1", "1", "4"}), (Share{0, 4}));
    EXPECT_EQ(share_of({"4", "1", "4"}), (Share{3, 4}));
}

TEST(Share, OfAnArraySaysWhatIsMissing) {
    const auto message = [](const ArrayTask& task) { return thrown_by([&] { share_of(task); }).message; };
    EXPECT_NE(message({"", "0", "16"}).find("SLURM_ARRAY_TASK_ID is not set"), std::string::npos);
    EXPECT_NE(message({"3", "", "16"}).find("SLURM_ARRAY_TASK_MIN is not set"), std::string::npos);
    EXPECT_NE(message({"3", "0", ""}).find("SLURM_ARRAY_TASK_COUNT is not set"), std::string::npos);
    EXPECT_NE(message({"x", "0", "16"}).find("SLURM_ARRAY_TASK_ID is \"x\", which is no number"), std::string::npos);
    // --array=0,2,4,6
    EXPECT_NE(message({"4", "0", "4"}).find("task 4 of the array has no share"), std::string::npos);
    EXPECT_NE(message({"0", "1", "4"}).find("task 0 of the array has no share"), std::string::npos);
}

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
