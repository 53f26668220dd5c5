#include "stridor/noise_library/library.hpp"

#include "stridor/base/sha256.hpp"
#include "stridor/noise_library/field.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <csignal>
#include <functional>

namespace stridor::noise_library {
namespace {

namespace fs = std::filesystem;
using support::CounterRandom;
using support::FullDisk;
using support::ScratchFolder;
using support::Thrown;
using support::thrown_by;

bool has_its_bytes(const Library& library, const Entry& entry) {
    return base::sha256_text(bytes_of(library.audio_file(entry))) == entry.audio;
}

std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

class LibraryFile : public testing::Test {
protected:
    Library open(Access access = Access::fill) const { return Library(file_, {access, std::chrono::milliseconds(50)}); }

    ScratchFolder folder_;
    fs::path file_ = folder_ / "library.sqlite";
    fs::path sound_ = folder_ / "sound.wav";
};

Query whole(Query query = {}) {
    query.extent = Extent::whole;
    return query;
}

// every field set to something
Entry full_entry() {
    Entry entry;
    double number = 0.5;
    for (const Field& field : fields())
        if (field.writer == Writer::stridor)
            continue;
        else if (std::holds_alternative<Quantity>(field.kind))
            quantity_in(entry, field) = number += 1.25;
        else
            words_in(entry, field) = "words of " + std::string(field.name);
    entry.recorded = "rig";
    entry.date = "2026-11-21";
    set_figure(entry, {"level", "dB", 62.5});
    set_figure(entry, {"kurtosis", "1", 0.1});
    return entry;
}

TEST_F(LibraryFile, VisitsWhatItFindsInTheSameOrder) {
    Library library = open();
    for (int k = 0; k < 600; ++k) {
        Entry entry = full_entry();
        entry.preload = (k * 37) % 101;
        add_bytes(library, sound_, std::to_string(k), entry);
    }
    Query query = whole();
    query.sort = "preload";
    query.conditions = parse_conditions("preload < 90 N");
    for (const std::size_t limit : {std::size_t{0}, std::size_t{300}}) {
        query.limit = limit;
        const std::vector<Entry> found = library.find(query);
        EXPECT_EQ(found.size(), limit == 0 ? static_cast<std::size_t>(library.count(query)) : limit);
        std::size_t place = 0;
        library.visit(query, [&](const Entry& entry) {
            ASSERT_LT(place, found.size());
            EXPECT_EQ(entry.id, found[place].id);
            EXPECT_EQ(digest(entry), digest(found[place]));
            ++place;
        });
        EXPECT_EQ(place, found.size());
    }
}

TEST_F(LibraryFile, GivesBackAnEntryInEveryWordAndBit) {
    Entry added;
    {
        Library library = open();
        added = add_bytes(library, sound_, "bytes", full_entry());
    }
    Library library = open(Access::read);
    const std::vector<Entry> back = library.find(whole());
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(digest(back[0]), digest(added));
    EXPECT_EQ(back[0].id, added.id);
    EXPECT_EQ(back[0].figures, added.figures);
    EXPECT_EQ(back[0].file, "sound.wav");
    EXPECT_EQ(bytes_of(library.audio_file(back[0])), "bytes");
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

TEST_F(LibraryFile, NamesAudioByItsContentBesideIt) {
    Library library = open();
    const Entry entry = add_bytes(library, folder_ / "A.WAV", "abc");
    EXPECT_EQ(library.audio_file(entry), folder_ / "library.audio" / "ba" /
                                             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad.wav");
    EXPECT_EQ(format_of("x.tar.gz"), "gz");
    EXPECT_EQ(format_of("x"), "audio");
    EXPECT_EQ(format_of("x.w/../v"), "audio");
    EXPECT_EQ(format_of("x.w v"), "audio");
}

TEST_F(LibraryFile, RefusesASoundItHasUnlessToldTo) {
    Library library = open();
    add_bytes(library, sound_, "bytes");
    const Thrown thrown = thrown_by([&] { add_bytes(library, sound_, "bytes"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("entry 1 has this sound")) << thrown.message;
    const Entry again = add_recording(library, {sound_, {}, Twins::accept}, probe_bytes);
    EXPECT_EQ(again.id, 2);
    EXPECT_EQ(files_of(library).size(), 1U);
    // the sound stays as long as one of them has it
    library.remove(std::vector<std::int64_t>{1});
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
    library.remove(std::vector<std::int64_t>{2});
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, NeverUsesAnIdTwice) {
    Library library = open();
    const std::int64_t first = add_bytes(library, sound_, "one").id;
    library.remove(std::vector<std::int64_t>{first});
    EXPECT_GT(add_bytes(library, sound_, "two").id, first);
}

TEST_F(LibraryFile, KeepsNothingOfWhatIsNoSound) {
    Library library = open();
    write_bytes(sound_, "bytes");
    const Probe refuse = [](const fs::path&, Entry&) { throw Error(ErrorKind::input, {"no sound", "", ""}); };
    EXPECT_TRUE(thrown_by([&] { add_recording(library, {sound_, {}}, refuse); }).says("no sound"));
    EXPECT_EQ(library.size(), 0);
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, RefusesAFileThatIsStillBeingWritten) {
    Library library = open();
    write_bytes(sound_, "bytes");
    const Probe grow = [](const fs::path& file, Entry&) { std::ofstream(file, std::ios::app) << "more"; };
    EXPECT_TRUE(thrown_by([&] { add_recording(library, {sound_, {}}, grow); }).says("still being written"));
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, ChangesEntriesAllOrNone) {
    Library library = open();
    const std::vector<std::int64_t> ids{add_bytes(library, sound_, "one", full_entry()).id,
                                        add_bytes(library, sound_, "two").id};
    const std::vector<Entry> changed = library.edit(ids, [](Entry& entry) {
        entry.preload = 7.0;
        entry.audio = "cannot be changed";
        entry.figures.clear();
    });
    EXPECT_EQ(changed.at(0).preload, 7.0);
    const std::vector<Entry> back = library.get(ids);
    EXPECT_EQ(digest(back[0]), digest(changed[0]));
    EXPECT_TRUE(back[0].figures.empty());
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");

    EXPECT_THROW(library.edit(ids,
                              [](Entry& entry) {
                                  if (entry.id == 2) throw Error(ErrorKind::input, {"no", "", ""});
                                  entry.preload = 9.0;
                              }),
                 Error);
    EXPECT_EQ(library.get(ids)[0].preload, 7.0);
}

TEST_F(LibraryFile, NamesAnIdThatIsNotThere) {
    Library library = open();
    EXPECT_TRUE(thrown_by([&] { library.get(std::vector<std::int64_t>{3}); }).says("the library is empty"));
    add_bytes(library, sound_, "one");
    const std::vector<std::int64_t> ids{1, 3};
    const Thrown thrown = thrown_by([&] { library.remove(ids); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("there is no entry 3") && thrown.says("1 entry, the last is 1")) << thrown.message;
    EXPECT_EQ(library.size(), 1);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

// conditions, looked at by code of their own
bool meets(const Entry& entry, const Condition& condition) {
    const Field& field = *find_field(condition.name);
    if (std::holds_alternative<Quantity>(field.kind)) {
        const double value = quantity_in(entry, field);
        const double other = parse_value(condition.value, unit_of(field));
        switch (condition.comparison) {
            case Comparison::equal:
                return value == other;
            case Comparison::different:
                return !std::isnan(value) && value != other;
            case Comparison::less:
                return value < other;
            case Comparison::at_most:
                return value <= other;
            case Comparison::more:
                return value > other;
            default:
                return value >= other;
        }
    }
    const std::string words = lowered(words_in(entry, field));
    const std::string other = lowered(condition.value);
    if (condition.comparison == Comparison::equal) return words == other;
    if (condition.comparison == Comparison::different) return !words.empty() && words != other;
    return words.find(other) != std::string::npos;
}

Entry random_entry(CounterRandom& random) {
    const char* const systems[] = {"", "brake", "Brake", "wiper", "door hinge"};
    Entry entry;
    entry.system = systems[random.below(5)];
    entry.materials = random.one_in(3) ? "EPDM / glass" : "";
    if (!random.one_in(4)) entry.preload = static_cast<double>(random.below(5)) * 10.0;
    if (!random.one_in(4)) entry.temperature = static_cast<double>(random.below(7)) * 10.0 - 20.0;
    return entry;
}

Condition random_condition(CounterRandom& random) {
    if (random.one_in(2)) {
        const char* const values[] = {"brake", "WIPER", "r", "hinge"};
        const Comparison comparisons[] = {Comparison::equal, Comparison::different, Comparison::contains};
        return {"system", comparisons[random.below(3)], values[random.below(4)]};
    }
    const bool is_preload = random.one_in(2);
    return {is_preload ? "preload" : "temperature", static_cast<Comparison>(random.below(6)),
            std::to_string(random.below(5) * 10) + (is_preload ? " N" : " degC")};
}

TEST_F(LibraryFile, FindsWhatAnIndependentFilterFinds) {
    CounterRandom random(1);
    Library library = open();
    std::vector<Entry> all;
    for (int k = 0; k < 60; ++k)
        all.push_back(add_bytes(library, sound_, std::to_string(k), random_entry(random)));
    for (int trial = 0; trial < 300; ++trial) {
        Query query;
        for (std::size_t k = random.below(3); k < 3; ++k)
            query.conditions.push_back(random_condition(random));
        std::vector<std::int64_t> expected;
        for (const Entry& entry : all)
            if (std::all_of(query.conditions.begin(), query.conditions.end(),
                            [&](const Condition& condition) { return meets(entry, condition); }))
                expected.push_back(entry.id);
        std::vector<std::int64_t> found;
        for (const Entry& entry : library.find(query))
            found.push_back(entry.id);
        EXPECT_EQ(found, expected);
    }
}

TEST_F(LibraryFile, FindsByFiguresDatesUnknownsAndWords) {
    Library library = open();
    Entry entry = full_entry();
    add_bytes(library, sound_, "one", entry);
    entry.date = "2025-03";
    entry.notes = "Gummi auf Glas";
    entry.figures.clear();
    set_figure(entry, {"level", "dB", 50.0});
    entry.preload = unknown;
    add_bytes(library, sound_, "two", entry);
    const auto ids = [&](const std::string& where, const std::string& search = "") {
        Query query;
        if (!where.empty()) query.conditions = parse_conditions(where);
        query.words = parse_words(search);
        std::string found;
        for (const Entry& each : library.find(query))
            found += std::to_string(each.id);
        return found;
    };
    EXPECT_EQ(ids("level > 60 dB"), "1");
    EXPECT_EQ(ids("level > 40"), "12");
    EXPECT_EQ(ids("kurtosis = unknown"), "2");
    EXPECT_EQ(ids("preload = unknown"), "2");
    EXPECT_EQ(ids("preload != unknown"), "1");
    EXPECT_EQ(ids("date < 2026-01"), "2");
    EXPECT_EQ(ids("id >= 2"), "2");
    EXPECT_EQ(ids("system = unknown"), "");
    EXPECT_EQ(ids("", "glas GUMMI"), "2");
    EXPECT_EQ(ids("", "sound.wav"), "12");
    EXPECT_EQ(ids("system = \"'; DROP TABLE entry; --\""), "");
    EXPECT_EQ(library.size(), 2);
    EXPECT_TRUE(thrown_by([&] { ids("prelaod > 1"); }).says("Did you mean \"preload\"?"));
    EXPECT_TRUE(thrown_by([&] { ids("kurtosi > 1"); }).says("Did you mean \"kurtosis\"?"));
    EXPECT_TRUE(thrown_by([&] { ids("preload > 1 mm"); }).says("preload: \"1 mm\" is a length"));
    EXPECT_TRUE(thrown_by([&] { ids("preload ~ 1"); }).says("is a number"));
    EXPECT_TRUE(thrown_by([&] { ids("system > a"); }).says("words"));
    EXPECT_TRUE(thrown_by([&] { ids("recorded = rgi"); }).says("Did you mean \"rig\"?"));
}

TEST_F(LibraryFile, SortsWithTheUnknownLast) {
    Library library = open();
    for (const double preload : {20.0, unknown, 40.0, 10.0}) {
        Entry entry;
        entry.preload = preload;
        if (preload > 10.0) set_figure(entry, {"level", "dB", -preload});
        add_bytes(library, sound_, std::to_string(preload), entry);
    }
    const auto order = [&](const char* key, Direction direction) {
        Query query;
        query.sort = key;
        query.direction = direction;
        std::string ids;
        for (const Entry& entry : library.find(query))
            ids += std::to_string(entry.id);
        return ids;
    };
    EXPECT_EQ(order("preload", Direction::rising), "4132");
    EXPECT_EQ(order("preload", Direction::falling), "3142");
    EXPECT_EQ(order("level", Direction::rising), "3124");
    EXPECT_EQ(order("", Direction::falling), "4321");
}

TEST_F(LibraryFile, ReadsSummariesWithoutDocumentsAndFigures) {
    Library library = open();
    add_bytes(library, sound_, "one", full_entry());
    const Entry summary = library.find({}).front();
    EXPECT_EQ(summary.case_text, "");
    EXPECT_TRUE(summary.figures.empty());
    EXPECT_EQ(summary.system, "words of system");
    EXPECT_EQ(library.words("system"), std::vector<std::string>{"words of system"});
    EXPECT_EQ(library.figures().size(), 2U);
}

// ---- what may stand where a library should

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
    storage::Database(file_, {}).execute("PRAGMA user_version = 2");
    const Thrown thrown = thrown_by([&] { open(Access::read); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("has schema 2") && thrown.says("newer program")) << thrown.message;
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

// ---- processes beside each other and dead ones

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
