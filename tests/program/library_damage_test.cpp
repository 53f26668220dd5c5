// Killed, full, damaged, filled by two at once: a library keeps what it said.

#include "program/library_program.hpp"
#include "support/effort.hpp"
#include "support/json_of.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <span>

using stridor::noise_library::Entry;
using stridor::noise_library::Library;
using stridor::support::CounterRandom;
using stridor::support::effort;
using stridor::support::Finished;
using stridor::support::Launch;
using stridor::support::LibraryProgram;
using stridor::support::Process;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::wav;
using stridor::support::with_file;
using stridor::support::write_text;

// a process of `arguments` that dies at an instant spread over its life, and a little beyond
class KilledLibrary : public LibraryProgram {
protected:
    void SetUp() override {
        for (int k = 0; k < 4; ++k)
            write_text(folder_ / ("s" + std::to_string(k) + ".wav"), wav(static_cast<std::uint64_t>(k), 50000));
        expect_done({"library", "add", "s0.wav", "s1.wav", "s2.wav", "s3.wav", "--library", "source.sqlite"});
        expect_done({"library", "export", "all.tar", "--library", "source.sqlite"});
        const auto started = std::chrono::steady_clock::now();
        expect_done({"library", "import", "all.tar", "--library", "timed.sqlite"});
        life_ = std::chrono::steady_clock::now() - started;
    }

    Finished killed(const std::vector<std::string>& arguments) {
        Process process(Launch{arguments, folder_.path(), {}, std::nullopt, {}});
        process.ends_within(life_ * random_.between(0.0, 1.2));
        process.send(SIGKILL);
        Finished finished = process.wait();
        const bool is_killed = finished.signal == SIGKILL;
        kills_ += is_killed ? 1 : 0;
        life_ *= is_killed ? 1.05 : 0.8;  // other programs make this one slower, and then faster again
        return finished;
    }
    std::size_t entries() const { return static_cast<std::size_t>(Library(folder_ / "library.sqlite").size()); }

    void remove_entries() const {
        Library library(folder_ / "library.sqlite");
        for (const Entry& entry : library.find({}))
            library.remove(std::span(&entry.id, 1));
    }

    static constexpr int kills = effort(60, 20);

    // what the program printed is there, a line per entry
    static std::size_t said(const Finished& finished) {
        return static_cast<std::size_t>(std::count(finished.out.begin(), finished.out.end(), '\n'));
    }

    std::chrono::duration<double> life_{};
    CounterRandom random_{4};
    int kills_ = 0;
};

TEST_F(KilledLibrary, HasEveryEntryThatAddSaidAndNothingHalf) {
    std::size_t before = 0;
    for (int k = 0; k < kills; ++k) {
        const Finished finished =
            killed(with_file({"library", "add", "s0.wav", "s1.wav", "s2.wav", "s3.wav", "--again"}));
        ASSERT_EQ(broken_promise(), "") << "kill " << k;
        ASSERT_GE(entries(), before + said(finished));
        ASSERT_LE(entries(), before + 4);
        before = entries();
        if (k % 10 == 9) {  // from an empty place again, where there is more to go wrong
            std::filesystem::remove(folder_ / "library.sqlite");
            std::filesystem::remove_all(folder_ / "library.audio");
            before = 0;
        }
    }
    EXPECT_GT(kills_, kills / 3) << "most kills came too late";
    expect_done(with_file({"library", "add", "s0.wav", "--again"}));
}

TEST_F(KilledLibrary, GoesOnWithAFolderWhereItWasKilled) {
    std::filesystem::create_directory(folder_ / "runs");
    for (int k = 0; k < 4; ++k)
        std::filesystem::copy(folder_ / ("s" + std::to_string(k) + ".wav"), folder_ / "runs");
    for (int k = 0; k < kills; ++k) {
        const std::size_t before = std::filesystem::exists(folder_ / "library.sqlite") ? entries() : 0;
        const Finished finished = killed(with_file({"library", "add", "runs"}));
        ASSERT_EQ(broken_promise(), "") << "kill " << k;
        ASSERT_GE(entries(), before + said(finished));
        ASSERT_LE(entries(), 4U);
        if (entries() == 4) remove_entries();
    }
    EXPECT_GT(kills_, kills / 3) << "most kills came too late";
    expect_done(with_file({"library", "add", "runs"}));
    EXPECT_EQ(entries(), 4U);
}

TEST_F(KilledLibrary, HasAllOfAnImportOrNothing) {
    for (int k = 0; k < kills; ++k) {
        const Finished finished = killed(with_file({"library", "import", "all.tar"}));
        ASSERT_EQ(broken_promise(), "") << "kill " << k;
        ASSERT_TRUE(entries() == 4 || (entries() == 0 && said(finished) == 0)) << entries();
        if (entries() == 4) remove_entries();
    }
    EXPECT_GT(kills_, kills / 3) << "most kills came too late";
    expect_done(with_file({"library", "import", "all.tar"}));
    EXPECT_EQ(entries(), 4U);
}

TEST_F(LibraryProgram, TakesTheRecordingsOfTwoProcessesAtOnce) {
    std::vector<std::string> first{"library", "add"};
    std::vector<std::string> second{"library", "add"};
    for (int k = 0; k < 20; ++k) {
        const std::string name = "s" + std::to_string(k) + ".wav";
        write_text(folder_ / name, wav(static_cast<std::uint64_t>(k)));
        (k % 2 == 0 ? first : second).push_back(name);
    }
    Process one(Launch{with_file(first), folder_.path(), {}, std::nullopt, {}});
    Process two(Launch{with_file(second), folder_.path(), {}, std::nullopt, {}});
    EXPECT_EQ(one.wait().exit_code, 0);
    EXPECT_EQ(two.wait().exit_code, 0);
    EXPECT_EQ(broken_promise(), "");
    EXPECT_EQ(Library(folder_ / "library.sqlite").size(), 20);
}

TEST_F(LibraryProgram, FindsDamageAndRepairsIt) {
    for (std::uint64_t k = 0; k < 3; ++k) {
        const std::string name = "sound" + std::to_string(k) + ".wav";
        write_text(folder_ / name, wav(k));
        expect_done(with_file({"library", "add", name, "--no-verdict", "--system", "seal"}));
    }
    expect_done(with_file({"library", "export", "all.tar"}));
    const Finished sound = stridor(with_file({"library", "check"}));
    EXPECT_EQ(sound.exit_code, 0);
    EXPECT_EQ(sound.out, "3 entries, 3 sounds: nothing is damaged\n");
    const std::string listed = stridor(with_file({"library", "list"})).out;

    std::string bytes = read_text(folder_ / "library.sqlite");
    bytes[8000] = static_cast<char>(bytes[8000] ^ 1);
    write_text(folder_ / "library.sqlite", bytes);
    expect_refused(with_file({"library", "list"}), 5, {"is damaged", "library check --repair"});
    const Finished damaged = stridor(with_file({"library", "check"}));
    EXPECT_EQ(damaged.exit_code, 5);
    EXPECT_NE(damaged.out.find("page 2 of "), std::string::npos) << damaged.out;

    const Finished repaired = stridor(with_file({"library", "check", "--repair", "all.tar"}));
    EXPECT_EQ(repaired.exit_code, 0) << repaired.err;
    EXPECT_NE(repaired.out.find("2 entries kept, 1 brought back"), std::string::npos) << repaired.out;
    EXPECT_EQ(stridor(with_file({"library", "list"})).out, listed);
    EXPECT_EQ(read_text(folder_ / "library.sqlite.damaged"), bytes);

    // a sound is damaged: it is found, and neither played nor compared
    const std::string audio = stridor(with_file({"library", "show", "2", "--audio"})).out;
    write_text(folder_ / audio.substr(0, audio.size() - 1), "other bytes");
    expect_refused(with_file({"library", "show", "2", "--audio"}), 5, {"the audio of entry 2 is damaged"});
    EXPECT_EQ(stridor(with_file({"library", "check", "--repair"})).exit_code, 5);
    EXPECT_EQ(stridor(with_file({"library", "check", "--repair", "all.tar"})).exit_code, 0);
    EXPECT_EQ(stridor(with_file({"library", "show", "2", "--audio"})).out, audio);
}

TEST_F(LibraryProgram, SaysThatTheDiskIsFull) {
    write_text(folder_ / "a.wav", wav(1, 100000));
    Launch launch{with_file({"library", "add", "a.wav"}), folder_.path(), {}, 65536, {}};
    const Finished finished = run(launch);
    EXPECT_EQ(finished.exit_code, 5) << finished.err;
    EXPECT_NE(finished.err.find("larger than files may be"), std::string::npos) << finished.err;
    EXPECT_EQ(broken_promise(), "");
}
