// What a noise library outlives: other files, damage, full disks, read-only media, other processes and dead ones.

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>

namespace stridor::noise_library {
namespace {

namespace fs = std::filesystem;
using support::CounterRandom;
using support::FullDisk;
using support::Thrown;
using support::thrown_by;

TEST_F(LibraryFile, IsNotMadeByAReader) {
    const Thrown thrown = thrown_by([&] { open(Access::read); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("there is no library")) << thrown.message;
    EXPECT_FALSE(fs::exists(file_));
}

TEST_F(LibraryFile, BeginsInAnEmptyFileThatAKillLeft) {
    write_bytes(file_, "");
    EXPECT_EQ(open(Access::read).size(), 0);
}

TEST_F(LibraryFile, RefusesOtherFilesAndLeavesThemAlone) {
    write_bytes(file_, std::string(10000, 'x'));
    Thrown thrown = thrown_by([&] { open(); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("is no library (it is not an SQLite database)")) << thrown.message;
    EXPECT_EQ(bytes_of(file_), std::string(10000, 'x'));

    fs::remove(file_);
    storage::Database(file_, {}).execute("CREATE TABLE entry(id)");
    thrown = thrown_by([&] { open(); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("another program's")) << thrown.message;
}

TEST_F(LibraryFile, RefusesANewerSchema) {
    open();
    storage::DatabaseOptions options;
    options.identity = library_identity;
    storage::Database(file_, options).execute("PRAGMA user_version = 3");
    const Thrown thrown = thrown_by([&] { open(Access::read); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("has schema 3") && thrown.says("newer program")) << thrown.message;
}

TEST_F(LibraryFile, EndsInAnErrorWhereItsFileIsDamaged) {
    {
        Library library = open();
        for (int k = 0; k < 30; ++k)
            add_bytes(library, sound_, std::to_string(k), full_entry());
    }
    const std::string bytes = bytes_of(file_);
    for (std::size_t size = 600; size < bytes.size(); size += 3001) {
        write_bytes(file_, bytes.substr(0, size));
        EXPECT_FALSE(thrown_by([&] { open(Access::read).find(whole()); }).message.empty()) << size;
    }
    // damaged inside: an error or entries, never a crash
    CounterRandom random(2);
    for (int trial = 0; trial < 200; ++trial) {
        std::string damaged = bytes;
        for (int k = 0; k < 20; ++k)
            damaged[100 + random.below(bytes.size() - 100)] = static_cast<char>(random.next());
        write_bytes(file_, damaged);
        try {
            Library library = open(Access::read);
            for (const Entry& entry : library.find(whole()))
                EXPECT_LE(library.audio_file(entry).native().size(), 1000U);
        } catch (const Error&) {
        }
    }
}

TEST_F(LibraryFile, WaitsForAWriterAndThenSaysThatItIsInUse) {
    Library library = open();
    storage::DatabaseOptions shared;
    shared.ownership = storage::Ownership::shared;
    storage::Database other(file_, shared);
    const storage::Transaction lock(other);
    EXPECT_EQ(library.size(), 0);  // readers go on
    const Thrown thrown = thrown_by([&] { add_bytes(library, sound_, "bytes"); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("is in use (another process has it open)")) << thrown.message;
}

TEST_F(LibraryFile, KeepsItsPromisesOnAFullDisk) {
    Library library = open();
    add_bytes(library, sound_, std::string(1000, 'a'));
    write_bytes(sound_, std::string(200000, 'b'));
    {
        const FullDisk full(100000);
        const Thrown thrown = thrown_by([&] { add_recording(library, {sound_, {}}, probe_bytes); });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("larger than files may be here")) << thrown.message;
    }
    EXPECT_EQ(library.size(), 1);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");

    // room for the sound, none for the row
    Entry long_notes;
    long_notes.notes = std::string(200000, 'n');
    write_bytes(sound_, "c");
    {
        const FullDisk full(100000);
        const Thrown thrown = thrown_by([&] { add_recording(library, {sound_, long_notes}, probe_bytes); });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("nothing was changed")) << thrown.message;
    }
    Library reopened = open();
    EXPECT_EQ(reopened.size(), 1);
    EXPECT_EQ(broken_promise(reopened, has_its_bytes), "");
    add_recording(reopened, {sound_, long_notes}, probe_bytes);
    EXPECT_EQ(broken_promise(reopened, has_its_bytes), "");
}

/// While it lives this process may not write into a folder and its files, whoever runs it.
class ReadOnly {
public:
    explicit ReadOnly(const fs::path& folder) : folder_(folder) {
        chmod_all(fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write, fs::perm_options::remove);
        if (geteuid() == 0) {
            fs::permissions(
                folder_,
                fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec,
                fs::perm_options::add);
            is_lowered_ = seteuid(65534) == 0;
        }
    }
    ~ReadOnly() {
        if (is_lowered_ && seteuid(0) != 0) abort();
        chmod_all(fs::perms::owner_write, fs::perm_options::add);
    }
    ReadOnly(const ReadOnly&) = delete;
    ReadOnly& operator=(const ReadOnly&) = delete;

private:
    void chmod_all(fs::perms perms, fs::perm_options how) const {
        fs::permissions(folder_, perms, how);
        for (const auto& each : fs::recursive_directory_iterator(folder_))
            fs::permissions(each.path(), perms, how);
    }
    fs::path folder_;
    bool is_lowered_ = false;
};

TEST_F(LibraryFile, CanBeReadAndNotWrittenOnReadOnlyMedia) {
    {
        Library library = open();
        add_bytes(library, sound_, "bytes");
    }
    const ReadOnly media(folder_.path());
    Library library = open(Access::read);
    EXPECT_EQ(library.find(whole()).size(), 1U);
    const Thrown added = thrown_by([&] { add_recording(library, {sound_, {}, Twins::accept}, probe_bytes); });
    EXPECT_EQ(added.kind, ErrorKind::io);
    EXPECT_TRUE(added.says("cannot write") && added.says("permission denied")) << added.message;
    const std::vector<std::int64_t> ids{1};
    EXPECT_EQ(thrown_by([&] { library.remove(ids); }).kind, ErrorKind::io);
    const Thrown edited = thrown_by([&] { library.edit(ids, [](Entry& entry) { entry.preload = 1.0; }); });
    EXPECT_EQ(edited.kind, ErrorKind::io);
    EXPECT_TRUE(edited.says("cannot write the library")) << edited.message;
}

// runs work in a process of its own; nothing of the test framework goes with it
pid_t forked(const std::function<void()>& work) {
    const pid_t id = fork();
    if (id != 0) return id;
    try {
        work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        _exit(1);
    }
    _exit(0);
}

int wait_for(pid_t id) {
    int status = 0;
    waitpid(id, &status, 0);
    return status;
}

TEST_F(LibraryFile, TakesEntriesOfSeveralProcessesAtOnce) {
    constexpr int each = 15;
    std::vector<pid_t> processes;
    for (int process = 0; process < 4; ++process)
        processes.push_back(forked([&] {
            Library library(file_, {Access::fill, std::chrono::seconds(30)});
            const fs::path sound = folder_ / ("sound" + std::to_string(process) + ".wav");
            for (int k = 0; k < each; ++k) {
                const Entry entry = add_bytes(library, sound, std::to_string(process) + "-" + std::to_string(k));
                // every third goes again, so that removing meets adding
                if (k % 3 == 2) library.remove(std::vector<std::int64_t>{entry.id});
            }
        }));
    for (const pid_t process : processes)
        EXPECT_EQ(wait_for(process), 0);
    Library library = open();
    EXPECT_EQ(library.size(), 4 * each * 2 / 3);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

TEST_F(LibraryFile, LosesNoSoundThatOneProcessAddsAndAnotherRemoves) {
    // one content for all: who removes the last entry of it must not take it from who adds the next
    std::vector<pid_t> processes;
    for (int process = 0; process < 3; ++process)
        processes.push_back(forked([&] {
            Library library(file_, {Access::fill, std::chrono::seconds(30)});
            const fs::path sound = folder_ / ("sound" + std::to_string(process) + ".wav");
            write_bytes(sound, "the same");
            for (int k = 0; k < 15; ++k) {
                const Entry entry = add_recording(library, {sound, {}, Twins::accept}, probe_bytes);
                if (!has_its_bytes(library, entry)) _exit(2);
                library.remove(std::vector<std::int64_t>{entry.id});
            }
        }));
    for (const pid_t process : processes)
        EXPECT_EQ(wait_for(process), 0);
    Library library = open();
    EXPECT_EQ(library.size(), 0);
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, ClearsWhatTheDeadLeftAndSparesTheLiving) {
    Library library = open();
    add_bytes(library, sound_, "kept");
    // a process that dies with a part written, one that dies with audio in its place
    wait_for(forked([&] {
        Intake intake(library.audio_folder());
        bool is_done = false;
        const Staged staged = intake.stage("wav", [&] { return std::exchange(is_done, true) ? "" : "part"; });
        _exit(0);
    }));
    wait_for(forked([&] {
        Intake intake(library.audio_folder());
        bool is_done = false;
        std::vector<Staged> staged;
        staged.push_back(intake.stage("wav", [&] { return std::exchange(is_done, true) ? "" : "orphan"; }));
        intake.place(staged, {staged[0].name});
        _exit(0);
    }));
    // a part whose marker went with the power
    write_bytes(library.audio_folder() / "incoming" / "1-0.0.part", "lost");

    Intake living(library.audio_folder());
    bool is_done = false;
    const Staged staged = living.stage("wav", [&] { return std::exchange(is_done, true) ? "" : "living"; });
    EXPECT_EQ(files_of(library).size(), 1U + 2U + 2U + 1U + 2U);
    Library opened = open();
    EXPECT_EQ(files_of(opened).size(), 1U + 2U) << "the kept sound, the living marker and its part";
    EXPECT_TRUE(has_its_bytes(opened, opened.find({}).front()));
}

// an old copy of the database beside the audio of today, and a process that died: what only today's rows name is spared
TEST_F(LibraryFile, SparesTheAudioOfADatabaseThatWasReplaced) {
    add_bytes(*std::make_unique<Library>(open()), sound_, "yesterday");
    const std::string backup = bytes_of(file_);
    add_bytes(*std::make_unique<Library>(open()), sound_, "today");
    const std::string newest = bytes_of(file_);
    write_bytes(file_, backup);
    wait_for(forked([&] {
        Library library = open();
        Marker marker(library.audio_folder());
        marker.announce({});
        _exit(0);
    }));
    EXPECT_EQ(open().size(), 1);
    write_bytes(file_, newest);
    Library library = open();
    EXPECT_EQ(library.size(), 2);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

}  // namespace
}  // namespace stridor::noise_library
