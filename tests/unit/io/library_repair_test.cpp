#include "stridor/io/library/library_repair.hpp"

#include "stridor/base/error.hpp"
#include "stridor/io/library/library_archive.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/checked_files.hpp"
#include "support/bit_flips.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

namespace stridor::io {
namespace {

namespace fs = std::filesystem;
using namespace noise_library;

class Repairing : public LibraryFile {
protected:
    Repairing() {
        Library library = open();
        for (int k = 0; k < 40; ++k) {
            Entry entry = full_entry();
            entry.system = "system " + std::to_string(k);
            entry.case_text = std::string(300, 'c') + std::to_string(k);
            add_bytes(library, sound_, "sound " + std::to_string(k), entry);
        }
        library.remove(std::vector<std::int64_t>{40, 7});
        before_ = library.find(whole());
        export_library(library, before_, archive_);
        bytes_ = bytes_of(file_);
    }

    Repair repaired(bool with_archive) const {
        std::vector<fs::path> archives;
        if (with_archive) archives.push_back(archive_);
        return repair_library(file_, archives, probe_bytes);
    }

    void damage(std::size_t place, std::size_t count) const {
        std::string bytes = bytes_;
        for (std::size_t k = place; k < std::min(place + count, bytes.size()); ++k)
            bytes[k] = static_cast<char>(bytes[k] ^ 0x41);
        write_bytes(file_, bytes);
    }

    fs::path archive_ = folder_ / "archive.tar";
    std::vector<Entry> before_;
    std::string bytes_;
};

std::vector<std::string> digests_of(const std::vector<Entry>& entries) {
    std::vector<std::string> digests;
    for (const Entry& entry : entries)
        digests.push_back(digest(entry));
    std::sort(digests.begin(), digests.end());
    return digests;
}

TEST_F(Repairing, LeavesASoundLibraryAlone) {
    EXPECT_TRUE(is_sound(check(file_)));
    const Repair repair = repaired(true);
    EXPECT_EQ(repair.kept, 38U);
    EXPECT_TRUE(repair.damaged_file.empty() && is_sound(repair.findings));
    EXPECT_EQ(bytes_of(file_), bytes_);
}

TEST_F(Repairing, FindsTheDamageOfEveryPage) {
    for (std::size_t page = 0; page < bytes_.size() / storage::page_size; ++page) {
        damage(page * storage::page_size + 777, 1);
        const Findings findings = check(file_);
        EXPECT_FALSE(is_sound(findings));
        ASSERT_EQ(findings.saved.damages.size(), 1U);
        EXPECT_TRUE(findings.saved.damages[0].starts_with("page " + std::to_string(page + 1) + " of "))
            << findings.saved.damages[0];
    }
}

// one byte of a page, whichever: all entries are there again with an archive, all but a few without
TEST_F(Repairing, SavesWhatIsWholeAndBringsBackTheRest) {
    const std::size_t pages = bytes_.size() / storage::page_size;
    std::size_t kept = 0;
    std::size_t trials = 0;
    for (std::size_t page = 0; page < pages; page += page == 0 ? 1 : support::effort(2, 9))
        for (const std::size_t place : {3U, 15U, 120U, 2000U, 4090U}) {
            ++trials;
            damage(page * storage::page_size + place, 1);
            const Repair repair = repaired(true);
            kept += repair.kept;
            EXPECT_TRUE(is_sound(repair.findings)) << page << " " << place;
            EXPECT_EQ(repair.from_sounds, 0U) << page << " " << place;
            Library library = open();
            EXPECT_EQ(digests_of(library.find(whole())), digests_of(before_)) << page << " " << place;
            EXPECT_EQ(broken_promise(library, has_its_bytes), "");
            EXPECT_EQ(bytes_of(repair.damaged_file).size(), bytes_.size());
            fs::remove(repair.damaged_file);
            EXPECT_EQ(folder_.files(), 4) << "library, sounds, archive, and the sound to add";
        }
    EXPECT_GT(kept, trials * 38 * 8 / 10) << "most was read from the damaged file itself";
}

TEST_F(Repairing, HearsTheSoundsOfWhatIsLostWithoutAnArchive) {
    // the whole file but its first pages
    damage(2 * storage::page_size, bytes_.size());
    const Repair repair = repaired(false);
    EXPECT_EQ(repair.kept + repair.from_sounds, 38U);
    EXPECT_GT(repair.from_sounds, 0U);
    EXPECT_TRUE(is_sound(repair.findings));
    Library library = open();
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
    EXPECT_EQ(library.find({}).back().notes, "made anew from its sound when the library was repaired");
}

TEST_F(Repairing, BringsBackWhatIsNothingButGarbage) {
    for (const std::string& garbage : {std::string(bytes_.size(), 'x').replace(0, 100, bytes_.substr(0, 100)),
                                       bytes_.substr(0, 5000), bytes_.substr(0, 1000)}) {
        write_bytes(file_, garbage);
        const Repair repair = repaired(true);
        EXPECT_TRUE(is_sound(repair.findings));
        EXPECT_EQ(digests_of(open().find(whole())), digests_of(before_));
    }
}

TEST_F(Repairing, NeverGivesANumberAgain) {
    damage(3 * storage::page_size + 2000, 1);
    static_cast<void>(repaired(false));
    Library library = open();
    EXPECT_GT(add_bytes(library, sound_, "new").id, 40);
}

TEST_F(Repairing, BringsBackSoundsFromAnArchive) {
    Library library = open();
    const fs::path missing = library.audio_file(before_[3]);
    const fs::path damaged = library.audio_file(before_[5]);
    fs::remove(missing);
    write_bytes(damaged, "other bytes");
    const Findings findings = check(file_);
    ASSERT_EQ(findings.damaged_sounds.size(), 2U);
    EXPECT_TRUE(findings.damaged_sounds[0].is_missing != findings.damaged_sounds[1].is_missing);
    EXPECT_EQ(repaired(false).findings.damaged_sounds.size(), 2U);
    const Repair repair = repaired(true);
    EXPECT_EQ(repair.mended_sounds, 2U);
    EXPECT_TRUE(is_sound(repair.findings));
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
    EXPECT_EQ(bytes_of(file_), bytes_);
}

TEST_F(Repairing, RefusesWhatIsNoLibraryAndLeavesItAlone) {
    write_bytes(file_, std::string(10000, 'x'));
    EXPECT_EQ(support::thrown_by([&] { repaired(true); }).kind, ErrorKind::input);
    EXPECT_EQ(bytes_of(file_), std::string(10000, 'x'));
}

}  // namespace
}  // namespace stridor::io
