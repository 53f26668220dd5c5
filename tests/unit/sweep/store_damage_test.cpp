// What becomes of a store whose bytes changed: the cells that were written, or an error, for each bit of it.

#include "stridor/base/error.hpp"
#include "stridor/storage/checked_files.hpp"
#include "stridor/sweep/starts.hpp"
#include "stridor/sweep/store/store.hpp"
#include "support/bit_flips.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <sstream>

namespace stridor::sweep {
namespace {

using support::Thrown;
using support::thrown_by;

// 3 by 3 cells in two directions, no two alike
Study damaged_study() {
    Study study = small_study();
    study.x.points = 3;
    return study;
}

std::vector<IndexedCell> written_cells(const Study& study) {
    std::vector<IndexedCell> cells;
    for (std::size_t index = 0; index < cell_count(study); ++index) {
        Cell cell;
        cell.status = index % 5 == 4 ? Status::failed : Status::done;
        cell.category = static_cast<classification::Category>(index % classification::category_names.size());
        if (cell.category == classification::Category::none) cell.quiet = classification::Quiet::sticks;
        if (index % 5 == 4) cell.message = "no valid start exists " + std::to_string(index);
        double value = 1.0 / static_cast<double>(index + 3);
        for (const CellFigure& figure : cell_figures())
            set_figure(cell, figure, value *= 1.7);
        cells.push_back({index, cell});
    }
    return cells;
}

// all that can be asked of a store
std::string told_by(const std::filesystem::path& file, const Study& study) {
    Store store(file, study);
    std::ostringstream text;
    for (const bool is_there : store.stored())
        text << is_there;
    const Counts counts = store.counts();
    for (const std::size_t count : counts.statuses)
        text << ' ' << count;
    for (const std::size_t count : counts.categories)
        text << ' ' << count;
    for (const IndexedCell& indexed : store.read()) {
        text << '\n' << indexed.index << ' ' << word(StartVerdict{indexed.cell.status, indexed.cell.category});
        text << ' ' << indexed.cell.message;
        for (const CellFigure& figure : cell_figures())
            text << ' ' << std::bit_cast<std::uint64_t>(figure_of(indexed.cell, figure));
    }
    return text.str();
}

class DamagedStore : public testing::Test {
protected:
    DamagedStore() { Store(file_, study_).write(written_cells(study_)); }

    void overwrite(const std::function<void(std::string&)>& change) const {
        std::string bytes = support::whole_file(file_);
        change(bytes);
        support::put_file(file_, bytes);
    }

    // somebody else's hand on the file, checksums and all
    void tamper(const std::string& sql) const {
        storage::DatabaseOptions options;
        options.identity = store_identity;
        storage::Database(file_, options).execute(sql);
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_ / "chart.sqlite";
    Study study_ = damaged_study();
};

TEST_F(DamagedStore, GivesTheSameCellsOrAnErrorForEveryBit) {
    const support::FlipCounts counts =
        support::flip_bits(file_, support::flip_step(31, 251), ErrorKind::io, [&] { return told_by(file_, study_); });
    EXPECT_GT(counts.refused, 100);
}

TEST_F(DamagedStore, SaysWhatToDo) {
    overwrite([](std::string& bytes) { bytes[2 * storage::page_size + 4000] ^= 1; });
    const Thrown thrown = thrown_by([&] { told_by(file_, study_); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_EQ(thrown.message, "the store " + file_.string() +
                                  " is damaged (a page does not have its checksum). Remove the file: the same command "
                                  "computes the same cells anew.");
}

TEST_F(DamagedStore, NoticesPagesThatStandInEachOthersPlace) {
    overwrite([](std::string& bytes) {
        const std::string page = bytes.substr(2 * storage::page_size, storage::page_size);
        bytes.replace(3 * storage::page_size, storage::page_size, page);
    });
    EXPECT_EQ(thrown_by([&] { told_by(file_, study_); }).kind, ErrorKind::io);
}

TEST_F(DamagedStore, NoticesALostPage) {
    const std::size_t pages = support::whole_file(file_).size() / storage::page_size;
    for (std::size_t page = 1; page < pages; ++page) {
        const std::string before = support::whole_file(file_);
        overwrite([&](std::string& bytes) {
            bytes.replace(page * storage::page_size, storage::page_size, std::string(storage::page_size, '\0'));
        });
        EXPECT_EQ(thrown_by([&] { told_by(file_, study_); }).kind, ErrorKind::io) << page;
        support::put_file(file_, before);
    }
}

TEST_F(DamagedStore, IsNotTakenForOneOfAnOlderLayout) {
    // one without reserved bytes and with an older layout's number is refused for that, as ever
    std::filesystem::remove(file_);
    storage::Database(file_, {}).execute("PRAGMA application_id = " + std::to_string(store_identity.application_id) +
                                         "; PRAGMA user_version = 2; CREATE TABLE meta(key, value)");
    const Thrown thrown = thrown_by([&] { Store(file_, study_); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("has schema 2 (this program reads and writes schema 3)")) << thrown.message;
}

// who knows how to make checksums may write anything; nothing of it is carried out or believed
TEST_F(DamagedStore, RefusesTriggersViewsAndOtherTables) {
    const std::string good = support::whole_file(file_);
    for (const char* sql : {"CREATE TRIGGER t AFTER INSERT ON cell BEGIN DELETE FROM meta; END",
                            "CREATE VIEW v AS SELECT 1", "CREATE TABLE more(x)", "CREATE INDEX i ON cell(status)",
                            "DROP TABLE cell", "DROP TABLE cell; CREATE VIEW cell AS SELECT 1 AS id"}) {
        tamper(sql);
        const Thrown thrown = thrown_by([&] { Store(file_, study_); });
        EXPECT_EQ(thrown.kind, ErrorKind::io) << sql;
        EXPECT_TRUE(thrown.says("its tables are not those that this program makes")) << sql << ": " << thrown.message;
        support::put_file(file_, good);
    }
}

TEST_F(DamagedStore, RefusesCellsBeyondItsStudy) {
    tamper("UPDATE cell SET id = 1000 WHERE id = 17");
    EXPECT_EQ(told_by(file_, study_).substr(0, 18), "111111111111111110") << "rows beyond the study are none of it";
    tamper("UPDATE cell SET id = -1 WHERE id = 16");
    EXPECT_EQ(told_by(file_, study_).substr(0, 18), "111111111111111100");
}

}  // namespace
}  // namespace stridor::sweep
