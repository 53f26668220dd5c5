#include "stridor/sweep/store/store.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace stridor::sweep {
namespace {

using support::Thrown;
using support::thrown_by;
using support::whole_between;

constexpr double infinity = std::numeric_limits<double>::infinity();

// one figure beside each other: the first has this value, the rest are its neighbours
Cell cell_with(double value) {
    Cell cell;
    cell.status = Status::done;
    cell.category = classification::Category::squeal;
    for (const CellFigure& figure : cell_figures())
        set_figure(cell, figure, value);
    return cell;
}

// every pattern of 64 bits but the payloads of NaN
Cell any_cell() {
    Cell cell;
    cell.status = static_cast<Status>(*whole_between(0, static_cast<int>(status_names.size()) - 1));
    cell.category = static_cast<classification::Category>(
        *whole_between(0, static_cast<int>(classification::category_names.size()) - 1));
    cell.message = *rc::gen::arbitrary<std::string>();
    const bool is_none = cell.status == Status::done && cell.category == classification::Category::none;
    if (is_none) cell.quiet = static_cast<classification::Quiet>(*whole_between(1, 3));
    for (const CellFigure& figure : cell_figures())
        set_figure(cell, figure, std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>()));
    return cell;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

// somebody else's hand on the file
void tamper(const std::filesystem::path& file, const std::string& sql) {
    storage::DatabaseOptions options;
    options.identity = store_identity;
    storage::Database(file, options).execute(sql);
}

class StoreFile : public testing::Test {
protected:
    Thrown thrown_by_opening(const Study& study) const {
        return thrown_by([&] { Store(file_, study); });
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_ / "chart.sqlite";
    Study study_ = small_study();
};

RC_GTEST_PROP(Store, GivesBackEveryCellBitForBit, ()) {
    const ScratchFolder folder;
    const Study study = small_study();
    std::vector<IndexedCell> cells;
    const int count = *whole_between(0, static_cast<int>(cell_count(study)));
    for (int k = 0; k < count; ++k)
        cells.push_back({static_cast<std::size_t>(k), any_cell()});
    {
        Store store(folder / "chart.sqlite", study);
        // the order of arrival is not that of the cells
        std::vector<IndexedCell> arrived(cells.rbegin(), cells.rend());
        const auto middle = static_cast<std::size_t>(*whole_between(0, count));
        store.write(std::span(arrived).first(middle));
        store.write(std::span(arrived).subspan(middle));
    }
    Store store(folder / "chart.sqlite", study);
    const std::vector<IndexedCell> back = store.read();
    RC_ASSERT(back.size() == cells.size());
    for (std::size_t k = 0; k < back.size(); ++k)
        RC_ASSERT(back[k].index == k && same_cell(back[k].cell, cells[k].cell));
}

TEST_F(StoreFile, ReadsTheFiguresThatAreAskedForAndTheRestOfTheCell) {
    Store store(file_, study_);
    Cell cell = cell_with(0.0);
    for (const CellFigure& figure : cell_figures())
        set_figure(cell, figure, static_cast<double>(figure.place));
    cell.message = "why";
    using classification::Category;
    using classification::Quiet;
    cell.starts = {{Status::diverged},
                   {Status::done, Category::none, Quiet::slides},
                   {Status::done, Category::none, Quiet::sticks},
                   {Status::done, Category::none, Quiet::locks}};
    store.write(std::vector{IndexedCell{1, cell}});
    const std::vector<CellFigure> wanted{cell_figure("mode_frequency"), cell_figure("slip")};
    std::size_t seen = 0;
    store.visit_figures(0, 2, wanted, [&](const IndexedCell& read) {
        ++seen;
        EXPECT_EQ(read.index, 1);
        EXPECT_EQ(read.cell.message, "why");
        EXPECT_EQ(read.cell.starts, cell.starts);
        EXPECT_EQ(verdict_of(read.cell).category, cell.category);
        for (const CellFigure& figure : wanted)
            EXPECT_EQ(figure_of(read.cell, figure), static_cast<double>(figure.place));
        EXPECT_TRUE(std::isnan(figure_of(read.cell, "stick"))) << "it was not read";
    });
    store.visit_figures(0, 2, {}, [&](const IndexedCell& read) {
        ++seen;
        EXPECT_EQ(verdict_of(read.cell).category, cell.category);
    });
    EXPECT_EQ(seen, 2);
}

TEST_F(StoreFile, KeepsTheNumbersThatOthersLose) {
    const std::vector<double> values{0.0,
                                     -0.0,
                                     infinity,
                                     -infinity,
                                     Cell::unknown,
                                     std::numeric_limits<double>::denorm_min(),
                                     -std::numeric_limits<double>::denorm_min(),
                                     std::numeric_limits<double>::max(),
                                     -3.0,
                                     0x1p53 + 2.0,
                                     0.1};
    Store store(file_, study_);
    for (std::size_t k = 0; k < values.size(); ++k)
        store.write(std::vector<IndexedCell>{{k, cell_with(values[k])}});
    const std::vector<IndexedCell> back = store.read();
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_TRUE(same_cell(back[k].cell, cell_with(values[k]))) << values[k];
}

TEST_F(StoreFile, KeepsTheVerdictOfEachStart) {
    Cell cell = cell_with(0.1);
    cell.starts = {{Status::done, classification::Category::squeal},
                   {Status::done, classification::Category::none, classification::Quiet::slides},
                   {Status::step_limit, classification::Category::undecided}};
    cell.agreement = Agreement::quiet_unless_disturbed;
    Store store(file_, study_);
    store.write(std::vector<IndexedCell>{{3, cell}, {4, cell_with(0.2)}});
    const std::vector<IndexedCell> back = store.read();
    EXPECT_TRUE(same_cell(back.at(0).cell, cell));
    EXPECT_TRUE(same_cell(back.at(1).cell, cell_with(0.2)));
}

TEST_F(StoreFile, KnowsAndCountsWhatItHolds) {
    Cell failed;
    failed.status = Status::failed;
    Store store(file_, study_);
    EXPECT_EQ(store.stored(), std::vector<bool>(cell_count(study_)));
    Cell locked = cell_with(3.0);
    locked.category = classification::Category::none;
    locked.quiet = classification::Quiet::locks;
    store.write(std::vector<IndexedCell>{{7, cell_with(1.0)}, {2, cell_with(2.0)}, {4, failed}, {5, locked}});
    std::vector<bool> expected(cell_count(study_));
    expected[2] = expected[4] = expected[5] = expected[7] = true;
    EXPECT_EQ(store.stored(), expected);
    const Counts counts = store.counts();
    EXPECT_EQ(counts.statuses[static_cast<std::size_t>(Status::done)], 3U);
    EXPECT_EQ(counts.statuses[static_cast<std::size_t>(Status::failed)], 1U);
    EXPECT_EQ(counts.locks, 1U);
    EXPECT_EQ(counts.categories[static_cast<std::size_t>(classification::Category::none)], 0U);
    EXPECT_EQ(counts.categories[static_cast<std::size_t>(classification::Category::squeal)], 2U);
    EXPECT_EQ(counts.categories[static_cast<std::size_t>(classification::Category::undecided)], 0U);
}

TEST_F(StoreFile, StandsAloneOnceClosed) {
    { Store(file_, study_).write(std::vector<IndexedCell>{{0, cell_with(1.0)}}); }
    EXPECT_EQ(folder_.files(), 1);
}

TEST_F(StoreFile, BeginsInAnEmptyFileThatAKillLeft) {
    write_bytes(file_, "");
    EXPECT_TRUE(Store(file_, study_).read().empty());
}

TEST_F(StoreFile, MayBeOpenedUnderAnotherTitle) {
    { Store(file_, study_).write(std::vector<IndexedCell>{{0, cell_with(1.0)}}); }
    study_.base.title = "another title";
    study_.quantities = {"frequency"};
    EXPECT_EQ(Store(file_, study_).read().size(), 1U);
}

TEST_F(StoreFile, NamesWhatItHoldsOtherwiseThanTheFile) {
    { Store store(file_, study_); }
    study_.base.contact().static_friction = 0.9;
    Thrown thrown = thrown_by_opening(study_);
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_EQ(thrown.message, "the store " + file_.string() +
                                  " belongs to another study (the store holds contact.static_friction = 0.8, the file "
                                  "says 0.9). Choose another --out, or remove the file to start anew.");

    study_ = small_study();
    study_.x.points = 5;
    EXPECT_TRUE(
        thrown_by_opening(study_).says("the store holds chart.x = contact.preload, 4 points from 2 to 400, log, "
                                       "the file says contact.preload, 5 points"));
    study_ = small_study();
    study_.base.run.initial = parameters::Initial::sliding;
    EXPECT_TRUE(thrown_by_opening(study_).says("the store holds run.initial = rest, the file says sliding"));
    study_ = small_study();
    study_.x.parameter = "joint.mass";
    EXPECT_TRUE(thrown_by_opening(study_).says("the file says contact.preload = 20 N, which the store does not hold"));
}

TEST_F(StoreFile, NamesWhatItHoldsAndTheFileDoesNot) {
    study_.base.run.initial = parameters::Initial::sliding;
    { Store store(file_, study_); }
    tamper(file_, "UPDATE meta SET value = replace(value, 'run.initial = sliding', 'run.initial = rest')");
    study_.base.run.initial = parameters::Initial::rest;
    EXPECT_TRUE(
        thrown_by_opening(study_).says("the store holds run.perturbation = 0.001 m/s, which the file does not say"));
}

TEST_F(StoreFile, RefusesAFileThatIsNoDatabaseAndLeavesItAlone) {
    for (const std::string& bytes : {std::string("hello"), std::string(10000, 'x')}) {
        write_bytes(file_, bytes);
        const Thrown thrown = thrown_by_opening(study_);
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        EXPECT_TRUE(thrown.says("is no store (it is not an SQLite database)")) << thrown.message;
        EXPECT_EQ(bytes_of(file_), bytes);
    }
}

TEST_F(StoreFile, RefusesAnotherProgramsDatabaseAndLeavesItAlone) {
    storage::Database(file_, {}).execute("CREATE TABLE meta(key, value)");
    const std::string bytes = bytes_of(file_);
    const Thrown thrown = thrown_by_opening(study_);
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("another program's SQLite database")) << thrown.message;
    EXPECT_EQ(bytes_of(file_), bytes);
}

TEST_F(StoreFile, RefusesAnotherSchema) {
    { Store store(file_, study_); }
    tamper(file_, "PRAGMA user_version = 99");
    const Thrown thrown = thrown_by_opening(study_);
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("has schema 99")) << thrown.message;
}

TEST_F(StoreFile, RefusesNumbersOfAnotherGeneration) {
    { Store store(file_, study_); }
    tamper(file_, "UPDATE meta SET value = '99' WHERE key = 'results'");
    const Thrown thrown = thrown_by_opening(study_);
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("its numbers are of generation 99")) << thrown.message;
}

TEST_F(StoreFile, RefusesASecondOwnerAtOnce) {
    Store store(file_, study_);
    const Thrown thrown = thrown_by_opening(study_);
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("is in use (another process has it open)")) << thrown.message;
    // the first one is not disturbed, not even between its writes
    store.write(std::vector<IndexedCell>{{0, cell_with(1.0)}});
    EXPECT_TRUE(thrown_by_opening(study_).says("is in use"));
    EXPECT_EQ(store.read().size(), 1U);
}

TEST_F(StoreFile, NamesWhoFillsItWhileItIsFilled) {
    {
        const Store store(file_, study_);
        EXPECT_FALSE(store.replaced());
        EXPECT_TRUE(storage::owner_of(file_));
    }
    EXPECT_FALSE(storage::owner_of(file_));
    const Store read(file_, study_, StoreUse::read);
    EXPECT_FALSE(storage::owner_of(file_)) << "who reads it owns nothing";
}

TEST_F(StoreFile, IsRefusedWhileAnotherHostFillsItAndTakenOverFromADeadProcess) {
    const std::string owner = storage::owner_file_of(file_).string();
    write_bytes(owner, storage::owner_text({"another-host", 17, "", "mark", 0}));
    for (const StoreUse use : {StoreUse::fill, StoreUse::read})
        EXPECT_TRUE(thrown_by([&] { Store(file_, study_, use); }).says("process 17 of host another-host fills it"));
    EXPECT_FALSE(std::filesystem::exists(file_));
    std::filesystem::remove(owner);
    storage::Owner former;
    {
        const Store store(file_, study_);
        former = storage::owner_of(file_)->owner;
    }
    former.process = 0x7fff'fff0;  // beyond any process of a machine
    write_bytes(owner, storage::owner_text(former));
    const Store store(file_, study_);
    ASSERT_TRUE(store.replaced());
    EXPECT_EQ(store.replaced()->owner.process, former.process);
}

TEST_F(StoreFile, SaysWhyItCannotBeOpened) {
    const Thrown thrown = thrown_by([&] { Store(folder_ / "nowhere/chart.sqlite", study_); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("nowhere/chart.sqlite (No such file or directory)")) << thrown.message;
}

TEST_F(StoreFile, NoticesCellsThatNoSweepWrote) {
    { Store(file_, study_).write(std::vector<IndexedCell>{{0, cell_with(1.0)}}); }
    tamper(file_, "UPDATE cell SET status = 'perhaps'");
    Store store(file_, study_);
    const Thrown thrown = thrown_by([&] { store.read(); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("is damaged (cell 0 is none of this study)")) << thrown.message;
}

TEST_F(StoreFile, EndsInAnErrorWhereItsFileWasCutShort) {
    {
        Store store(file_, study_);
        for (std::size_t k = 0; k < cell_count(study_); ++k)
            store.write(std::vector<IndexedCell>{{k, cell_with(0.1)}});
    }
    const std::string bytes = bytes_of(file_);
    // a single byte is what SQLite itself may write into an empty file
    for (std::size_t size = 2; size < bytes.size(); size += 1021) {
        write_bytes(file_, bytes.substr(0, size));
        const Thrown thrown = thrown_by([&] { Store(file_, study_).read(); });
        EXPECT_FALSE(thrown.message.empty()) << size << " of " << bytes.size() << " bytes";
    }
}

TEST_F(StoreFile, KeepsEveryCommittedCellThroughAFullDisk) {
    Cell cell = cell_with(0.1);
    cell.message = std::string(3000, 'm');
    std::size_t written = 0;
    {
        Store store(file_, study_);
        const FullDisk full(40000);
        const Thrown thrown = thrown_by([&] {
            for (; written < cell_count(study_); ++written)
                store.write(std::vector<IndexedCell>{{written, cell}});
        });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("cannot write the store " + file_.string() + " (File too large)")) << thrown.message;
    }
    EXPECT_GT(written, 0U);
    Store store(file_, study_);
    EXPECT_EQ(store.read().size(), written);
    for (; written < cell_count(study_); ++written)
        store.write(std::vector<IndexedCell>{{written, cell}});
    EXPECT_EQ(load(study_, store).cells.size(), cell_count(study_));
}

TEST_F(StoreFile, CanBeBegunAgainAfterTheDiskWasFullFromTheStart) {
    {
        const FullDisk full(1000);
        EXPECT_EQ(thrown_by_opening(study_).kind, ErrorKind::io);
    }
    EXPECT_TRUE(Store(file_, study_).read().empty());
}

TEST_F(StoreFile, IsNotLoadedBeforeItIsComplete) {
    Store store(file_, study_);
    store.write(std::vector<IndexedCell>{{0, cell_with(1.0)}, {3, cell_with(1.0)}});
    const Thrown thrown = thrown_by([&] { load(study_, store); });
    EXPECT_EQ(thrown.kind, ErrorKind::interrupted);
    EXPECT_TRUE(thrown.says("holds 2 of 24 cells)")) << thrown.message;
}

}  // namespace
}  // namespace stridor::sweep
