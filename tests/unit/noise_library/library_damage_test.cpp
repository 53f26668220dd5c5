// What becomes of a library whose bytes changed, and of one of the layout before there were checksums.

#include "stridor/base/text.hpp"
#include "stridor/noise_library/entry_rows.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/storage/checked_files.hpp"
#include "support/bit_flips.hpp"
#include "support/error_text.hpp"
#include "support/wait.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace stridor::noise_library {
namespace {

namespace fs = std::filesystem;
using support::Thrown;
using support::thrown_by;

// an entry as text, to the last bit
std::string told(const Entry& entry) {
    std::string text = std::to_string(entry.id) + " " + digest(entry);
    for (const Figure& figure : entry.figures)
        text += " " + figure.name + "=" + base::shortest(figure.value) + figure.unit;
    return text + "\n";
}

// all that can be asked of a library, along every index; sounds are looked at
std::string told_by(const fs::path& file) {
    Library library(file, {Access::read, std::chrono::milliseconds(50)});
    std::string text = std::to_string(library.size()) + "\n";
    for (const char* sort : {"", "preload", "system", "level"}) {
        Query query;
        query.sort = sort;
        query.extent = EntryExtent::whole;
        for (const Entry& entry : library.find(query))
            text += told(entry);
    }
    for (const FigureKind& figure : library.figures())
        text += figure.name + figure.unit + "\n";
    for (const std::string& word : library.words("system"))
        text += word + "\n";
    Query by_audio;
    by_audio.extent = EntryExtent::whole;
    for (const Entry& entry : library.find(by_audio)) {
        by_audio.conditions = {{"audio", Comparison::equal, entry.audio}};
        text += std::to_string(library.count(by_audio)) + library.sound_file(entry).filename().string() + "\n";
    }
    return text;
}

class DamagedLibrary : public LibraryFile {
protected:
    void fill(int entries) {
        Library library = open();
        for (int k = 0; k < entries; ++k) {
            Entry entry = full_entry();
            entry.preload = 10.0 * k;
            entry.system = "system " + std::to_string(k);
            entry.case_text = "[joint]\nmass = 0.1\n";
            add_bytes(library, sound_, "sound " + std::to_string(k), entry);
        }
    }

    // somebody else's hand on the file, checksums and all
    void tamper(const std::string& sql) const {
        storage::DatabaseOptions options;
        options.identity = library_identity;
        storage::Database(file_, options).execute(sql);
    }

    // the library as the program before wrote it, without reserved bytes
    void make_old(int entries) {
        fill(entries);
        std::vector<Entry> known = open().find(whole());
        fs::remove(file_);
        storage::Database old(file_, {});
        storage::Transaction transaction(old);
        create_tables(old);
        for (const Entry& entry : known)
            write_entry(old, entry);
        old.execute("PRAGMA user_version = 1");
        transaction.commit();
    }
};

TEST_F(DamagedLibrary, GivesTheSameEntriesOrAnErrorForEveryBit) {
    fill(3);
    const support::FlipCounts counts =
        support::flip_bits(file_, support::flip_step(67, 509), ErrorKind::io, [&] { return told_by(file_); });
    EXPECT_GT(counts.refused, 100);
}

TEST_F(DamagedLibrary, NoticesEveryBitOfASound) {
    fill(1);
    const fs::path sound = open().audio_file(open().find({}).front());
    const support::FlipCounts counts = support::flip_bits(sound, 1, ErrorKind::io, [&] { return told_by(file_); });
    EXPECT_EQ(counts.same, 0);
    EXPECT_EQ(counts.refused, 8 * static_cast<long>(std::string("sound 0").size()));
}

TEST_F(DamagedLibrary, ChangesNothingOnceItIsDamaged) {
    fill(3);
    std::string bytes = bytes_of(file_);
    bytes[storage::page_size + 4000] ^= 1;
    write_bytes(file_, bytes);
    const Thrown added = thrown_by([&] {
        Library library = open();
        add_bytes(library, sound_, "more", full_entry());
    });
    EXPECT_EQ(added.kind, ErrorKind::io);
    EXPECT_TRUE(added.says("is damaged (a page does not have its checksum)")) << added.message;
    EXPECT_EQ(bytes_of(file_), bytes);
}

// a process that died within a change, with pages of it in the file already
TEST_F(DamagedLibrary, IsUndoneToWhatItWasOrRefusedWhateverBitOfTheJournalIsWrong) {
    fill(12);
    const std::string good = told_by(file_);
    const pid_t id = fork();
    if (id == 0) {
        storage::DatabaseOptions options;
        options.identity = library_identity;
        storage::Database database(file_, options);
        database.execute("PRAGMA cache_size = 1");
        database.execute("BEGIN");
        for (std::int64_t entry = 12; entry > 2; --entry) {
            Entry changed = read_entry(database, entry).entry;
            changed.notes = std::string(500, 'n');
            write_entry(database, changed);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(id, &status, 0);
    const fs::path journal = file_.string() + "-journal";
    const std::string bytes = bytes_of(file_);
    const std::string undo = bytes_of(journal);
    ASSERT_GT(undo.size(), storage::page_size);
    const auto opened = [&] {
        write_bytes(file_, bytes);
        return told_by(file_);
    };
    write_bytes(journal, undo);
    EXPECT_EQ(opened(), good) << "the sound journal undoes the change";
    long refused = 0;
    // all bits of what is not a page, some of the pages
    for (std::size_t bit = 0; bit < 8 * undo.size(); bit += bit < 8 * 40 ? 1 : support::flip_step(1009, 8009)) {
        std::string damaged = undo;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        write_bytes(journal, damaged);
        try {
            ASSERT_EQ(opened(), good) << bit;
        } catch (const Error& error) {
            ASSERT_EQ(error.kind(), ErrorKind::io) << bit << ": " << error.what();
            ++refused;
        }
        fs::remove(journal);
    }
    EXPECT_GT(refused, 20);
}

TEST_F(DamagedLibrary, RefusesTriggersViewsAndOtherTables) {
    fill(1);
    const std::string good = bytes_of(file_);
    for (const char* sql : {"CREATE TRIGGER t AFTER INSERT ON entry BEGIN DELETE FROM entry; END",
                            "CREATE VIEW v AS SELECT 1", "CREATE TABLE more(x)", "DROP INDEX entry_audio"}) {
        tamper(sql);
        const Thrown thrown = thrown_by([&] { open(); });
        EXPECT_EQ(thrown.kind, ErrorKind::io) << sql;
        EXPECT_TRUE(thrown.says("its tables are not those that this program makes")) << thrown.message;
        write_bytes(file_, good);
    }
}

TEST_F(DamagedLibrary, FreesPagesThatHaveTheirChecksums) {
    fill(1);
    {
        Library library = open();
        for (int round = 0; round < 3; ++round) {
            Entry entry = full_entry();
            entry.case_text = std::string(100'000, 'c');
            const Entry added = add_bytes(library, sound_, "long", entry);
            library.remove(std::vector<std::int64_t>{added.id});
        }
    }
    storage::DatabaseOptions options;
    options.identity = library_identity;
    storage::Database database(file_, options);
    EXPECT_GT(database.integer("PRAGMA freelist_count"), 0);
    EXPECT_TRUE(database.is_checked());
    EXPECT_EQ(database.damages(), std::vector<std::string>());
}

TEST_F(DamagedLibrary, IsBroughtUpToDateWithAllItHolds) {
    make_old(5);
    // the last number was given, and its entry removed
    {
        storage::Database old(file_, {});
        old.execute("UPDATE sqlite_sequence SET seq = 12");
    }
    fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
    std::string before;
    storage::Database old(file_, {});
    for (const std::int64_t id : entry_ids(old))
        before += told(read_entry(old, id).entry);

    // a reader does it, too
    std::string after;
    Library library = open(Access::read);
    for (const Entry& entry : library.find(whole()))
        after += told(entry);
    EXPECT_EQ(after, before);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
    EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(add_bytes(library, sound_, "new").id, 13);
    EXPECT_EQ(folder_.files(), 3) << "library, sounds, and the sound to add";

    // who had the old file open does not write into nowhere
    const Thrown lost = thrown_by([&] { old.execute("DELETE FROM entry"); });
    EXPECT_EQ(lost.kind, ErrorKind::io) << lost.message;
    EXPECT_EQ(library.size(), 6);
}

TEST_F(DamagedLibrary, IsNotBroughtUpToDateWhereAnEntryIsNotWhatWasWritten) {
    make_old(3);
    storage::Database(file_, {}).execute("UPDATE entry SET preload = 11 WHERE id = 2");
    const std::string bytes = bytes_of(file_);
    const Thrown thrown = thrown_by([&] { open(); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("entry 2 is not what was written")) << thrown.message;
    EXPECT_EQ(bytes_of(file_), bytes);
    EXPECT_EQ(folder_.files(), 3);
}

TEST_F(DamagedLibrary, IsBroughtUpToDateByExactlyOneOfManyAndSurvivesTheDeathOfOne) {
    make_old(20);
    for (int round = 0; round < 6; ++round) {
        std::vector<pid_t> processes;
        for (int k = 0; k < 3; ++k) {
            const pid_t id = fork();
            if (id == 0) {
                try {
                    Library library(file_, {Access::read, std::chrono::seconds(30)});
                    _exit(library.size() == 20 ? 0 : 1);
                } catch (const std::exception& error) {
                    std::fprintf(stderr, "%s\n", error.what());
                    _exit(2);
                }
            }
            processes.push_back(id);
        }
        // the first is killed at the beginning, or once so much of the new library is there
        const fs::path made = file_.string() + ".new";
        const auto is_far = [&] {
            std::error_code none;
            const std::uintmax_t size = fs::file_size(made, none);
            siginfo_t ended{};
            waitid(P_PID, static_cast<id_t>(processes[0]), &ended, WEXITED | WNOHANG | WNOWAIT);
            return (!none && size >= 16384U * static_cast<unsigned>(round - 1)) || ended.si_pid != 0;
        };
        EXPECT_TRUE(support::wait_until([&] { return round == 0 || is_far(); }));
        kill(processes[0], SIGKILL);
        for (std::size_t k = 0; k < processes.size(); ++k) {
            int status = 0;
            waitpid(processes[k], &status, 0);
            EXPECT_TRUE(k == 0 || status == 0) << status;
        }
        Library library = open();
        EXPECT_EQ(library.size(), 20);
        EXPECT_EQ(broken_promise(library, has_its_bytes), "");
        EXPECT_FALSE(fs::exists(file_.string() + ".new"));
        fs::remove(file_);
        fs::remove_all(library.audio_folder());
        make_old(20);
    }
}

}  // namespace
}  // namespace stridor::noise_library
