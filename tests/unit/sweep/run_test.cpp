#include "stridor/sweep/run.hpp"

#include "stridor/base/error.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace stridor::sweep {
namespace {

using support::Thrown;
using support::thrown_by;

std::size_t sum(std::span<const std::size_t> counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

class Run : public testing::Test {
protected:
    std::vector<Cell> cells() { return all_cells(load(study_, store_)); }

    ScratchFolder folder_;
    Study study_ = small_study();
    Store store_{folder_ / "chart.sqlite", study_};
};

TEST_F(Run, StoresTheCellsOfEveryPoint) {
    const RunReport report = run(study_, store_);
    EXPECT_EQ(report.ending, SweepEnding::completed);
    EXPECT_EQ(report.computed, cell_count(study_));
    const std::vector<Cell> stored = cells();
    for (std::size_t index = 0; index < stored.size(); ++index) {
        const CellPlace place = place_of(study_, index);
        EXPECT_TRUE(same_cell(stored[index], evaluate(study_, place.ix, place.iy)[place.direction])) << index;
    }
}

TEST_F(Run, ComputesOnlyWhatIsMissing) {
    Cell mark;
    mark.status = Status::failed;
    mark.message = "not computed again";
    // both directions of the point iy = 2, ix = 1
    const std::vector<IndexedCell> there{{index_of(study_, {0, 2, 1}), mark}, {index_of(study_, {1, 2, 1}), mark}};
    store_.write(there);
    const RunReport report = run(study_, store_);
    EXPECT_EQ(report.computed, cell_count(study_) - 2);
    const std::vector<Cell> stored = cells();
    for (const IndexedCell& indexed : there)
        EXPECT_TRUE(same_cell(stored[indexed.index], mark));
}

TEST_F(Run, DoesNothingWhenAllIsThere) {
    run(study_, store_);
    const std::vector<Cell> before = cells();
    const RunReport report = run(study_, store_);
    EXPECT_EQ(report.ending, SweepEnding::completed);
    EXPECT_EQ(report.computed, 0U);
    EXPECT_EQ(report.progress.done, report.progress.total);
    EXPECT_TRUE(same_cells(cells(), before));
}

TEST_F(Run, ReportsProgressFromTheCallersThreadUpToTheEnd) {
    std::vector<Progress> reports;
    RunOptions options;
    options.progress = [&, owner = std::this_thread::get_id()](const Progress& progress) {
        EXPECT_EQ(std::this_thread::get_id(), owner);
        reports.push_back(progress);
    };
    const RunReport report = run(study_, store_, options);
    ASSERT_GE(reports.size(), 2U);
    EXPECT_EQ(reports.front().done, 0U);
    EXPECT_EQ(reports.back().done, cell_count(study_));
    for (const Progress& progress : reports) {
        EXPECT_EQ(progress.total, cell_count(study_));
        EXPECT_EQ(sum(progress.counts.statuses), progress.done);
        EXPECT_EQ(sum(progress.counts.categories), progress.counts.statuses[0]);
    }
    EXPECT_EQ(report.progress.counts.categories, store_.counts().categories);
    EXPECT_GT(report.progress.rate, 0.0);
}

TEST_F(Run, CountsTheCellsOfEarlierRunsAsDone) {
    run(study_, store_);
    std::size_t first = 0;
    RunOptions options;
    options.progress = [&](const Progress& progress) { first = progress.done; };
    run(study_, store_, options);
    EXPECT_EQ(first, cell_count(study_));
}

TEST_F(Run, ComputesNothingWhenStoppedBefore) {
    std::stop_source source;
    source.request_stop();
    RunOptions options;
    options.stop = source.get_token();
    const RunReport report = run(study_, store_, options);
    EXPECT_EQ(report.ending, SweepEnding::stopped);
    EXPECT_EQ(report.computed, 0U);
    EXPECT_TRUE(store_.read().empty());
}

TEST_F(Run, StopsRunsThatWouldTakeHours) {
    study_.base.run.duration = 1e6;
    study_.base.run.early_ending = parameters::EarlyEnding::never;
    ScratchFolder other;
    Store store(other / "chart.sqlite", study_);
    std::stop_source source;
    RunOptions options;
    options.stop = source.get_token();
    // the first report comes before the work, the second amid it
    int reports = 0;
    options.progress = [&](const Progress&) {
        if (++reports == 2) source.request_stop();
    };
    EXPECT_EQ(run(study_, store, options).ending, SweepEnding::stopped);
    EXPECT_TRUE(store.read().empty());
}

TEST_F(Run, PassesOnWhatAWorkerThrows) {
    study_.base.run.initial = parameters::Initial::sliding;
    study_.base.drive.kind = parameters::DriveKind::sampled;
    // V = 0 at t = 0, between two samples: nothing before the run sees it
    study_.base.drive.times = {-0.02, 0.02};
    study_.base.drive.velocities = {-0.1, 0.1};
    ScratchFolder other;
    Store store(other / "chart.sqlite", study_);
    const Thrown thrown = thrown_by([&] { run(study_, store); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("has no direction")) << thrown.message;
}

TEST_F(Run, PassesOnWhatTheCallbackThrows) {
    RunOptions options;
    options.progress = [](const Progress& progress) {
        if (progress.done > 0) throw std::logic_error("enough");
    };
    EXPECT_THROW(run(study_, store_, options), std::logic_error);
    EXPECT_FALSE(store_.read().empty()) << "what was finished by then is kept";
}

// the runs of a share are every second block of neighbours
TEST_F(Run, ComputesItsShareOnly) {
    Study study = small_study();
    study.x.points = 64;
    study.y.points = 40;
    study.base.run.duration = 0.002;
    study.base.run.window = 0.001;
    for (const std::size_t index : {0U, 1U}) {
        MemoryKeeper keeper(study);
        RunOptions options;
        options.share = {index, 2};
        const RunReport report = run(study, keeper, options);
        EXPECT_EQ(report.ending, SweepEnding::completed);
        const std::vector<bool> there = keeper.stored();
        for (std::size_t run = 0; run < there.size(); ++run)
            ASSERT_EQ(there[run], is_in(options.share, study, run)) << run;
        EXPECT_EQ(report.progress.total, report.computed);
        EXPECT_EQ(sweep::run(study, keeper, options).computed, 0U);
    }
}

class RefinedRun : public testing::Test {
protected:
    RefinedRun() {
        study_.x.points = 33;
        study_.y.points = 33;
        study_.refine = 3;
    }

    // the complete chart of the same study
    SweepResult complete() {
        Study study = study_;
        study.refine = 0;
        const auto store = std::make_shared<Store>(folder_ / "complete.sqlite", study);
        run(study, *store);
        return load(study, store);
    }

    ScratchFolder folder_;
    Study study_ = small_study();
};

TEST_F(RefinedRun, ComputesAPartOfTheCellsAndHasTheRestRight) {
    Store store(folder_ / "refined.sqlite", study_);
    const RunReport report = run(study_, store);
    EXPECT_EQ(report.ending, SweepEnding::completed);
    EXPECT_EQ(report.progress.done, report.computed);
    EXPECT_EQ(report.progress.total, report.computed);
    const SweepResult refined = load(study_, store);
    const SweepResult whole = complete();
    std::size_t computed = 0;
    std::size_t right = 0;
    for (std::size_t index = 0; index < refined.cells.size(); ++index) {
        right += refined.cells[index].category == whole.cells[index].category ? 1 : 0;
        if (is_inferred(refined, index)) continue;
        ++computed;
        EXPECT_TRUE(same_cell(computed_cell(refined, index), computed_cell(whole, index))) << index;
    }
    EXPECT_EQ(computed, report.computed);
    EXPECT_EQ(store.read().size(), computed) << "inferred cells are not kept";
    EXPECT_LT(4 * computed, 3 * refined.cells.size());
    EXPECT_GT(static_cast<double>(right), 0.98 * static_cast<double>(refined.cells.size()));
}

TEST_F(RefinedRun, GoesOnFromAnyPartOfItsCells) {
    Store whole(folder_ / "whole.sqlite", study_);
    run(study_, whole);
    const std::vector<IndexedCell> cells = whole.read();
    for (const std::size_t stride : {2U, 7U}) {
        Store part(folder_ / ("part-" + std::to_string(stride)), study_);
        std::vector<IndexedCell> kept;
        for (std::size_t k = 0; k < cells.size(); k += stride)
            kept.push_back(cells[k]);
        part.write(kept);
        EXPECT_EQ(thrown_by([&] { load(study_, part); }).kind, ErrorKind::interrupted);
        run(study_, part);
        EXPECT_TRUE(same_cells(all_cells(load(study_, part)), all_cells(load(study_, whole)))) << stride;
        EXPECT_EQ(part.read().size(), cells.size()) << stride;
    }
}

TEST_F(RefinedRun, IsNotCompleteWhenItIsStoppedBetweenRounds) {
    MemoryKeeper keeper(study_);
    std::stop_source source;
    RunOptions options;
    options.stop = source.get_token();
    options.round = [&] { source.request_stop(); };
    EXPECT_EQ(run(study_, keeper, options).ending, SweepEnding::stopped);
}

TEST_F(RefinedRun, DoesNothingWhenAllIsThere) {
    Store store(folder_ / "refined.sqlite", study_);
    run(study_, store);
    EXPECT_EQ(run(study_, store).computed, 0U);
}

TEST_F(Run, PassesOnThatTheDiskIsFullAndGoesOnLater) {
    RunOptions options;
    options.cells_per_commit = 1;
    {
        const FullDisk full(16384);
        const Thrown thrown = thrown_by([&] { run(study_, store_, options); });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("cannot write the store")) << thrown.message;
    }
    EXPECT_LT(store_.read().size(), cell_count(study_));
    EXPECT_EQ(run(study_, store_, options).ending, SweepEnding::completed);
}

// refined, so that it has rounds
Study refined_study() {
    Study study = small_study();
    study.x.points = 17;
    study.y.points = 9;
    study.refine = 2;
    return study;
}

TEST(RunInMemory, KeepsTheCellsThatAStoreKeeps) {
    const ScratchFolder folder;
    const Study study = refined_study();
    Store store(folder / "chart.sqlite", study);
    const auto memory = std::make_shared<MemoryKeeper>(study);
    run(study, store);
    EXPECT_EQ(run(study, *memory).computed, sum(store.counts().statuses));
    EXPECT_EQ(memory->stored(), store.stored());
    EXPECT_EQ(memory->counts().categories, store.counts().categories);
    EXPECT_TRUE(same_cells(all_cells(load(study, memory)), all_cells(load(study, store))));
    EXPECT_EQ(run(study, *memory).computed, 0U);
}

TEST(RunInMemory, ShowsEveryRoundWithTheNearestOfTheKnownCells) {
    const Study study = refined_study();
    const auto memory = std::make_shared<MemoryKeeper>(study);
    std::vector<std::size_t> computed;
    RunOptions options;
    options.round = [&] {
        const SweepResult result = provisional(study, memory);
        computed.push_back(computed_count(result));
        for (std::size_t index = 0; index < result.cells.size(); ++index) {
            const CellPlace here = place_of(study, index);
            const CellPlace source = place_of(study, source_of(result, index));
            EXPECT_EQ(source.direction, here.direction);
            // the base grid takes every fourth point
            EXPECT_LE(std::abs(source.ix - here.ix), 2);
            EXPECT_LE(std::abs(source.iy - here.iy), 2);
            EXPECT_EQ(result.cells[index].category, result.cells[source_of(result, index)].category);
        }
    };
    const RunReport report = run(study, *memory, options);
    ASSERT_FALSE(computed.empty());
    EXPECT_TRUE(std::is_sorted(computed.begin(), computed.end()));
    EXPECT_LT(computed.back(), report.computed);
    EXPECT_EQ(all_cells(provisional(study, memory)).size(), cell_count(study));
}

TEST(RunInMemory, HasNoResultInADirectionOfWhichNothingIsKnownYet) {
    const Study study = refined_study();
    const auto memory = std::make_shared<MemoryKeeper>(study);
    Cell quiet;
    quiet.status = Status::done;
    quiet.category = classification::Category::none;
    memory->write(std::vector{IndexedCell{2, quiet}});
    const SweepResult result = provisional(study, memory);
    ASSERT_EQ(study.directions.size(), 2U);
    for (std::size_t index = 0; index < result.cells.size(); ++index) {
        const bool is_first = index < result.cells.size() / 2;
        EXPECT_EQ(result.cells[index].status, is_first ? Status::done : Status::failed) << index;
        EXPECT_EQ(source_of(result, index), is_first ? 2U : index);
    }
}

}  // namespace
}  // namespace stridor::sweep
