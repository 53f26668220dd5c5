#include "stridor/sweep/store/merge.hpp"

#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/starts.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/store/share_keeper.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <numeric>

namespace stridor::sweep {
namespace {

using support::thrown_by;

// any cell of a chart, from its index alone
Cell invented(const Study& study, std::size_t index) {
    Cell cell;
    cell.status = index % 11 == 0 ? Status::failed : Status::done;
    if (cell.status == Status::failed) cell.message = "no valid start " + std::to_string(index);
    if (cell.status == Status::done) {
        cell.category = static_cast<classification::Category>(1 + index / 7 % 3);
        for (const CellFigure& figure : cell_figures())
            set_figure(cell, figure, std::sin(static_cast<double>(index + figure.place)));
    }
    for (std::size_t k = 0; k < study.starts.size(); ++k)
        cell.starts.push_back({cell.status, cell.category});
    return cell;
}

class Merge : public testing::Test {
protected:
    // blocks of 140 runs for four shares, sixteen for each
    Study plain_study() const {
        Study study = small_study();
        study.x.points = 64;
        study.y.points = 70;
        return study;
    }

    void make_share(const Study& study, const Share& share, const std::filesystem::path& folder) const {
        std::filesystem::create_directories(shares_folder(folder));
        Store store(share_file(folder, share), study);
        std::vector<IndexedCell> cells;
        for (std::size_t index = cell_count(study); index-- > 0;)
            if (is_in(share, study, index)) cells.push_back({index, invented(study, index)});
        store.write(cells);
    }

    void make_shares(const Study& study, std::size_t count, const std::filesystem::path& folder) const {
        for (std::size_t index = count; index-- > 0;)
            make_share(study, {index, count}, folder);
    }

    std::string bytes(const std::string& folder) const {
        return storage::read_file((folder_ / folder / "chart.sqlite").string());
    }

    void expect_invented(const Study& study, const std::string& folder) const {
        Store store(folder_ / folder / "chart.sqlite", study, StoreUse::read);
        const std::vector<IndexedCell> cells = store.read();
        ASSERT_EQ(cells.size(), cell_count(study));
        for (std::size_t index = 0; index < cells.size(); ++index)
            ASSERT_TRUE(cells[index].index == index && same_cell(cells[index].cell, invented(study, index))) << index;
    }

    ScratchFolder folder_;
};

TEST_F(Merge, GivesTheSameBytesForAnyNumberOfShares) {
    for (const bool has_starts : {false, true}) {
        Study study = plain_study();
        if (has_starts) study.starts = {parameters::Initial::rest, parameters::Initial::stuck};
        const std::string kind = has_starts ? "starts-" : "plain-";
        for (const std::size_t count : {1U, 2U, 5U, 16U}) {
            const std::string name = kind + std::to_string(count);
            make_shares(study, count, folder_ / name);
            const MergeReport report = merge(study, folder_ / name);
            EXPECT_TRUE(report.missing.empty());
            EXPECT_EQ(report.cells, cell_count(study));
            EXPECT_EQ(report.shares.size(), count);
            EXPECT_EQ(bytes(name), bytes(kind + "1")) << count;
            expect_invented(study, name);
        }
    }
}

TEST_F(Merge, GivesTheSameBytesHoweverOftenAndInWhateverOrder) {
    const Study study = plain_study();
    make_shares(study, 1, folder_ / "once");
    merge(study, folder_ / "once");
    for (const std::size_t index : {3U, 0U, 4U, 1U, 2U}) {
        make_share(study, {index, 5}, folder_ / "often");
        merge(study, folder_ / "often");
        if (index == 0) std::filesystem::remove_all(shares_folder(folder_ / "often"));
    }
    EXPECT_EQ(bytes("often"), bytes("once"));
    EXPECT_TRUE(merge(study, folder_ / "often").missing.empty());
    EXPECT_EQ(bytes("often"), bytes("once")) << "of a merged store alone";
    // the store of a single run, filled in any order, is brought into order likewise
    {
        std::filesystem::create_directory(folder_ / "single");
        Store store(folder_ / "single" / "chart.sqlite", study);
        for (std::size_t index = 0; index < cell_count(study); index += 2)
            store.write(std::vector<IndexedCell>{{index, invented(study, index)}});
        std::vector<IndexedCell> rest;
        for (std::size_t index = 1; index < cell_count(study); index += 2)
            rest.push_back({index, invented(study, index)});
        store.write(rest);
    }
    merge(study, folder_ / "single");
    EXPECT_EQ(bytes("single"), bytes("once"));
}

TEST_F(Merge, GivesTheSameBytesHoweverFewStoresAreOpenAtATime) {
    const Study study = plain_study();
    make_shares(study, 1, folder_ / "one");
    merge(study, folder_ / "one");
    for (const std::size_t most : {2U, 3U, 7U}) {
        const std::string name = "open-" + std::to_string(most);
        make_shares(study, 16, folder_ / name);
        make_share(study, {1, 5}, folder_ / name);  // its cells are those of others, too
        MergeOptions options;
        options.most_open = most;
        EXPECT_EQ(merge(study, folder_ / name, options).cells, cell_count(study));
        EXPECT_EQ(bytes(name), bytes("one")) << most;
    }
}

TEST_F(Merge, OpensNoMoreStoresThanTheProcessMay) {
    const Study study = plain_study();
    make_shares(study, 48, folder_ / "out");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    rlimit few = before;
    few.rlim_cur = 40;
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    EXPECT_NO_THROW(merge(study, folder_ / "out"));
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    expect_invented(study, "out");
}

TEST_F(Merge, SaysWhatIsMissing) {
    const Study study = plain_study();
    for (const std::size_t index : {0U, 2U, 3U})
        make_share(study, {index, 4}, folder_ / "out");
    const MergeReport report = merge(study, folder_ / "out");
    EXPECT_EQ(report.shares.size(), 3U);
    EXPECT_EQ(report.missing_cells, 16U * 140U);
    EXPECT_EQ(report.cells + report.missing_cells, cell_count(study));
    ASSERT_FALSE(report.missing.empty());
    for (const std::size_t run : report.missing)
        EXPECT_TRUE(is_in({1, 4}, study, run));
}

// each share goes on from what all of them have found, until nothing is asked of any
TEST_F(Merge, OfARefinedChartEndsWithTheCellsOfASingleRun) {
    Study study = small_study();
    study.x.points = 65;
    study.y.points = 49;
    study.refine = 3;
    study.starts = {parameters::Initial::rest, parameters::Initial::stuck};
    std::vector<IndexedCell> single;
    {
        Store store(folder_ / "single.sqlite", study);
        ASSERT_EQ(run(study, store).ending, SweepEnding::completed);
        single = store.read();
    }
    ASSERT_LT(single.size(), cell_count(study));
    for (const std::size_t count : {1U, 2U, 5U}) {
        const std::string name = std::to_string(count);
        std::filesystem::create_directories(shares_folder(folder_ / name));
        MergeReport report;
        int rounds = 0;
        do {
            for (std::size_t index = 0; index < count; ++index) {
                ShareKeeper keeper(share_file(folder_ / name, {index, count}), folder_ / name / "chart.sqlite", study);
                RunOptions options;
                options.share = {index, count};
                run(study, keeper, options);
            }
            report = merge(study, folder_ / name);
        } while (!report.missing.empty() && ++rounds < 20);
        EXPECT_LT(rounds, 20);
        Store store(folder_ / name / "chart.sqlite", study, StoreUse::read);
        const std::vector<IndexedCell> cells = store.read();
        ASSERT_EQ(cells.size(), single.size()) << count;
        for (std::size_t k = 0; k < cells.size(); ++k)
            ASSERT_TRUE(cells[k].index == single[k].index && same_cell(cells[k].cell, single[k].cell)) << k;
        EXPECT_EQ(bytes(name), bytes("1")) << count;
    }
}

TEST_F(Merge, RefusesAShareOfAnotherStudyByName) {
    const Study study = plain_study();
    make_shares(study, 2, folder_ / "out");
    Study other = study;
    other.base.contact().static_friction = 0.7;
    std::filesystem::remove(share_file(folder_ / "out", {1, 2}));
    make_share(other, {1, 2}, folder_ / "out");
    const support::Thrown thrown = thrown_by([&] { merge(study, folder_ / "out"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("0001-of-0002.sqlite belongs to another study")) << thrown.message;
    EXPECT_TRUE(thrown.says("contact.static_friction")) << thrown.message;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "chart.sqlite")) << "nothing is left behind";
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "chart.sqlite.new"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "chart.sqlite.owner"));
}

TEST_F(Merge, RefusesATornShareByNameAndLeavesTheChartAsItWas) {
    const Study study = plain_study();
    make_share(study, {0, 2}, folder_ / "out");
    merge(study, folder_ / "out");
    const std::string before = bytes("out");
    make_share(study, {1, 2}, folder_ / "out");
    const std::filesystem::path torn = share_file(folder_ / "out", {1, 2});
    const std::string whole = storage::read_file(torn.string());
    // cut in the middle, and one bit of a cell turned over
    std::string turned = whole;
    turned[whole.size() / 2] = static_cast<char>(turned[whole.size() / 2] ^ 4);
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), turned}) {
        storage::write_file(torn.string(), damaged);
        const support::Thrown thrown = thrown_by([&] { merge(study, folder_ / "out"); });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("0001-of-0002.sqlite is damaged")) << thrown.message;
        EXPECT_EQ(bytes("out"), before);
    }
}

TEST_F(Merge, RefusesAShareThatContradictsAnotherByName) {
    const Study study = plain_study();
    make_shares(study, 2, folder_ / "out");
    make_share(study, {3, 5}, folder_ / "out");
    EXPECT_NO_THROW(merge(study, folder_ / "out")) << "a cell that is there twice and is the same";
    Cell other = invented(study, 4000);
    set_figure(other, cell_figures().back(), std::nextafter(figure_of(other, cell_figures().back()), 2.0));
    Store(share_file(folder_ / "out", {4, 5}), study).write(std::vector<IndexedCell>{{4000, other}});
    const support::Thrown thrown = thrown_by([&] { merge(study, folder_ / "out"); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("cell 4000 is not the same in ")) << thrown.message;
    EXPECT_TRUE(thrown.says("0004-of-0005.sqlite")) << thrown.message;
}

TEST_F(Merge, LeavesOutAShareThatIsBeingFilled) {
    const Study study = plain_study();
    make_shares(study, 2, folder_ / "out");
    const std::filesystem::path file = share_file(folder_ / "out", {1, 2});
    storage::write_file(storage::owner_file_of(file).string(), storage::owner_text({"another-host", 17, "", "m", 0}));
    const MergeReport report = merge(study, folder_ / "out");
    ASSERT_EQ(report.shares.size(), 2U);
    EXPECT_FALSE(report.shares[0].is_filled);
    EXPECT_TRUE(report.shares[1].is_filled);
    EXPECT_EQ(report.missing_cells, 4480U);
}

TEST_F(Merge, IsRefusedWhileTheChartItselfIsBeingFilled) {
    const Study study = plain_study();
    make_shares(study, 2, folder_ / "out");
    const std::filesystem::path owner = folder_ / "out" / "chart.sqlite.owner";
    storage::write_file(owner.string(), storage::owner_text({"another-host", 17, "", "m", 0}));
    EXPECT_TRUE(thrown_by([&] { merge(study, folder_ / "out"); }).says("process 17 of host another-host fills it"));
}

TEST_F(Merge, StopsOnRequestAndLeavesEverythingAsItWas) {
    const Study study = plain_study();
    make_shares(study, 2, folder_ / "out");
    std::stop_source stop;
    stop.request_stop();
    MergeOptions options;
    options.stop = stop.get_token();
    EXPECT_EQ(thrown_by([&] { merge(study, folder_ / "out", options); }).kind, ErrorKind::interrupted);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "chart.sqlite"));
}

TEST_F(Merge, KnowsSharesByTheirNames) {
    EXPECT_EQ(share_of_file_name("0003-of-0016"), (Share{3, 16}));
    for (const char* name : {"", "3-of-16", "0003-of-0003", "0003-of-0016-copy", "x-of-y", "0003-0016"})
        EXPECT_FALSE(share_of_file_name(name)) << name;
}

}  // namespace
}  // namespace stridor::sweep
