#include "stridor/storage/owner_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

namespace stridor::storage {
namespace {

using support::thrown_by;
using support::wait_until;

class OwnerOf : public testing::Test {
protected:
    OwnerOptions options(const std::string& host) const {
        OwnerOptions options;
        options.shown = "the store chart.sqlite";
        options.host = host;
        return options;
    }

    // as if its owner had been silent for so long
    void age(long seconds) const {
        struct stat status {};
        ASSERT_EQ(::stat(name_.c_str(), &status), 0);
        const timespec times[2] = {status.st_atim, {status.st_mtim.tv_sec - seconds, status.st_mtim.tv_nsec}};
        ASSERT_EQ(::utimensat(AT_FDCWD, name_.c_str(), times, 0), 0);
    }

    void leave(const Owner& owner, long silence) const {
        write_file(name_.string(), owner_text(owner));
        age(silence);
    }

    // a process that is no more
    static long dead_process() {
        const pid_t child = ::fork();
        if (child == 0) ::_exit(0);
        ::waitpid(child, nullptr, 0);
        return child;
    }

    support::ScratchFolder folder_;
    std::filesystem::path file_ = folder_ / "chart.sqlite";
    std::filesystem::path name_ = folder_ / "chart.sqlite.owner";
};

TEST_F(OwnerOf, AFileIsNamedWhileItIsFilledAndGoneAfterwards) {
    EXPECT_FALSE(owner_of(file_));
    {
        OwnerFile owner(file_, options("n1"));
        owner.confirm();
        const std::optional<SeenOwner> seen = owner_of(file_);
        ASSERT_TRUE(seen);
        EXPECT_EQ(seen->owner.host, "n1");
        EXPECT_EQ(seen->owner.process, ::getpid());
        EXPECT_GE(seen->silence, 0.0);
        EXPECT_LT(seen->silence, 30.0);
        EXPECT_FALSE(owner.replaced());
        EXPECT_EQ(folder_.files(), 1) << "nothing else is left beside it";
        EXPECT_NO_THROW(owner.expect_own());
    }
    EXPECT_EQ(folder_.files(), 0);
}

TEST_F(OwnerOf, AFileOfAnotherHostIsRefusedWithWhoAndHowLongAgo) {
    leave({"n2", 17, "4711", "someone", 5}, 40);
    const support::Thrown thrown = thrown_by([&] { OwnerFile(file_, options("n1")); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(
        thrown.says("the store chart.sqlite is in use (process 17 of host n2, job 4711 fills it, and was last "
                    "heard of 40 s ago)"))
        << thrown.message;
    EXPECT_EQ(owner_of(file_)->owner.mark, "someone");
    EXPECT_EQ(folder_.files(), 1);
}

TEST_F(OwnerOf, AFileOfAnotherHostIsTakenOverAfterAMinuteOfSilence) {
    leave({"n2", 17, "4711", "someone", 5}, 61);
    const OwnerFile owner(file_, options("n1"));
    EXPECT_EQ(owner_of(file_)->owner.host, "n1");
    ASSERT_TRUE(owner.replaced());
    EXPECT_EQ(text_of(owner.replaced()->owner), "process 17 of host n2, job 4711");
    EXPECT_NEAR(owner.replaced()->silence, 61.0, 5.0);
    EXPECT_EQ(folder_.files(), 1);
}

TEST_F(OwnerOf, AFileOfThisHostIsLeftToTheLock) {
    leave({"n1", dead_process(), "", "someone", 5}, 3);
    {
        const OwnerFile not_confirmed(file_, options("n1"));
        EXPECT_EQ(owner_of(file_)->owner.mark, "someone") << "the lock has not been asked yet";
    }
    EXPECT_EQ(owner_of(file_)->owner.mark, "someone") << "who never had it does not give it back";
    OwnerFile owner(file_, options("n1"));
    owner.confirm();
    EXPECT_NE(owner_of(file_)->owner.mark, "someone");
    ASSERT_TRUE(owner.replaced());
}

TEST_F(OwnerOf, AFileWithoutALockIsRefusedToALivingNeighbourToo) {
    OwnerOptions without_lock = options("n1");
    without_lock.has_lock = false;
    leave({"n1", ::getpid(), "", "someone", 5}, 3);
    EXPECT_TRUE(thrown_by([&] { OwnerFile(file_, without_lock); }).says("of host n1 fills it"));
    leave({"n1", dead_process(), "", "someone", 5}, 3);
    const OwnerFile owner(file_, without_lock);
    EXPECT_TRUE(owner.replaced());
}

TEST_F(OwnerOf, AFileLearnsThatItWasTakenOver) {
    OwnerOptions quick = options("n1");
    quick.heartbeat = std::chrono::milliseconds(5);
    auto former = std::make_unique<OwnerFile>(file_, quick);
    leave({"n2", 17, "", "another", 0}, 0);
    ASSERT_TRUE(wait_until([&] {
        try {
            former->expect_own();
            return false;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::io);
            EXPECT_NE(std::string(error.what()).find("process 17 of host n2 has taken it over"), std::string::npos);
            return true;
        }
    }));
    former.reset();
    EXPECT_EQ(owner_of(file_)->owner.mark, "another") << "what is another's is not removed";
}

TEST_F(OwnerOf, AFileThatWasRemovedIsNoLongerItsOwn) {
    OwnerOptions quick = options("n1");
    quick.heartbeat = std::chrono::milliseconds(5);
    OwnerFile owner(file_, quick);
    std::filesystem::remove(name_);
    EXPECT_TRUE(wait_until([&] {
        try {
            owner.expect_own();
            return false;
        } catch (const Error& error) {
            return std::string(error.what()).find("chart.sqlite.owner was removed") != std::string::npos;
        }
    }));
}

TEST_F(OwnerOf, AFileKeepsGivingSignsOfLifeAndTellsHowFarItIs) {
    OwnerOptions quick = options("n1");
    quick.heartbeat = std::chrono::milliseconds(5);
    OwnerFile owner(file_, quick);
    age(1000);
    owner.tell(123);
    EXPECT_TRUE(wait_until([&] {
        const std::optional<SeenOwner> seen = owner_of(file_);
        return seen && seen->owner.count == 123 && seen->silence < 100.0;
    }));
    EXPECT_NO_THROW(owner.expect_own());
}

// many takers at once, as if from many hosts, of a file whose owner has died: one gets it
TEST_F(OwnerOf, ADeadHostsFileIsTakenOverByExactlyOne) {
    for (int round = 0; round < 40; ++round) {
        leave({"dead", 17, "", "someone", 0}, 100);
        constexpr int takers = 6;
        std::latch begin(takers);
        std::vector<std::unique_ptr<OwnerFile>> owners(takers);
        std::atomic<int> refused = 0;
        {
            std::vector<std::jthread> threads;
            for (int k = 0; k < takers; ++k)
                threads.emplace_back([&, k] {
                    begin.arrive_and_wait();
                    try {
                        owners[static_cast<std::size_t>(k)] =
                            std::make_unique<OwnerFile>(file_, options("n" + std::to_string(k)));
                    } catch (const Error&) {
                        ++refused;
                    }
                });
        }
        ASSERT_EQ(refused, takers - 1);
        for (const std::unique_ptr<OwnerFile>& owner : owners) {
            if (owner) owner->expect_own();
        }
        owners.clear();
        ASSERT_EQ(folder_.files(), 0) << "round " << round;
    }
}

TEST_F(OwnerOf, AFileWhoseTakerDiedAmidIsTakenOverAllTheSame) {
    leave({"n2", 17, "", "someone", 0}, 100);
    const std::filesystem::path lock = folder_ / "chart.sqlite.owner.lock";
    write_file(lock.string(), "");
    const timespec times[2] = {{1, 0}, {1, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, lock.c_str(), times, 0), 0);
    const OwnerFile owner(file_, options("n1"));
    EXPECT_TRUE(owner.replaced());
    EXPECT_EQ(folder_.files(), 1);
}

TEST_F(OwnerOf, AFileWhoseTakerOfThisHostDiedAmidIsNotWaitedFor) {
    leave({"n2", 17, "", "someone", 0}, 100);
    write_file((folder_ / "chart.sqlite.owner.lock").string(), owner_text({"n1", dead_process(), "", "taker", 0}));
    const OwnerFile owner(file_, options("n1"));
    EXPECT_TRUE(owner.replaced());
    EXPECT_EQ(folder_.files(), 1);
}

// what a kill leaves that comes while an owner's file is made
TEST_F(OwnerOf, WhatKillsHaveLeftBesideItIsRemovedByTheNextAndOfTheLivingNothing) {
    const auto draft = [&](const std::string& digits, const Owner& owner, long age) {
        const std::filesystem::path name = name_.string() + "." + digits;
        write_file(name.string(), owner.mark.empty() ? "" : owner_text(owner));
        const std::time_t then = std::time(nullptr) - age;
        const timespec times[2] = {{then, 0}, {then, 0}};
        EXPECT_EQ(::utimensat(AT_FDCWD, name.c_str(), times, 0), 0);
        return name;
    };
    constexpr long hour = 3600;
    const Owner unknown;
    const auto dead = draft("00000000000000aa", {"n1", dead_process(), "", "a", 0}, 1);
    const auto far = draft("00000000000000bb", {"n2", 1, "", "b", 0}, hour + 60);
    const auto unwritten = draft("00000000000000cc", unknown, hour + 60);
    const auto living = draft("00000000000000dd", {"n1", ::getpid(), "", "d", 0}, 10 * hour);
    const auto far_and_young = draft("00000000000000ee", {"n2", 1, "", "e", 0}, hour - 60);
    const auto unwritten_yet = draft("00000000000000ff", unknown, 1);
    const auto other = draft("notes", {"n1", dead_process(), "", "f", 0}, 10 * hour);
    {
        const OwnerFile owner(file_, options("n1"));
        for (const auto& name : {dead, far, unwritten})
            EXPECT_FALSE(std::filesystem::exists(name)) << name;
        for (const auto& name : {living, far_and_young, unwritten_yet, other})
            EXPECT_TRUE(std::filesystem::exists(name)) << name;
    }
    EXPECT_EQ(folder_.files(), 4);
}

TEST_F(OwnerOf, TellsAtOnceWhenTheFileChangesAndWhenItDoesNot) {
    OwnerFile owner(file_, options("n1"));
    const auto changes = [&] { return owner_of(file_)->owner.changes; };
    EXPECT_EQ(changes(), 1) << "nobody may look before it says so";
    owner.tell(7);
    owner.end_change();
    EXPECT_EQ(changes(), 2);
    EXPECT_EQ(owner_of(file_)->owner.count, 7);
    owner.begin_change();
    EXPECT_EQ(changes(), 3);
    owner.begin_change();
    EXPECT_EQ(changes(), 3) << "a change that failed goes on";
    owner.end_change();
    EXPECT_EQ(changes(), 4);
    leave({"n2", 17, "", "another", 0}, 0);
    EXPECT_TRUE(thrown_by([&] { owner.begin_change(); }).says("process 17 of host n2 has taken it over"));
    EXPECT_TRUE(thrown_by([&] { owner.end_change(); }).says("process 17 of host n2 has taken it over"));
    EXPECT_FALSE(owner.may_change());
    EXPECT_EQ(owner_of(file_)->owner.mark, "another") << "its file is not touched";
}

// a merge holds no lock on what it replaces, so a neighbour's lock says nothing
TEST_F(OwnerOf, AFileThatANeighbourFillsWithoutALockIsRefusedEvenWithOne) {
    OwnerOptions without_lock = options("n1");
    without_lock.has_lock = false;
    const OwnerFile merging(file_, without_lock);
    EXPECT_TRUE(thrown_by([&] { OwnerFile(file_, options("n1")); }).says("of host n1 fills it"));
}

// it stands still with the lock: who comes may not make it lose its claim
TEST_F(OwnerOf, AFileOfASilentProcessOfThisHostIsLeftToTheLockToo) {
    leave({"n1", ::getpid(), "", "someone", 5}, 1000);
    { const OwnerFile other(file_, options("n1")); }
    EXPECT_EQ(owner_of(file_)->owner.mark, "someone");
}

// who took over died before what the one before him has open was out of the way
TEST_F(OwnerOf, AFileThatWasNotHandedOverMayStillBeInOtherHands) {
    leave({"n2", 17, "", "stands still", 5}, 100);
    Owner died{"n1", dead_process(), "", "died", 5};
    {
        OwnerFile owner(file_, options("n1"));
        EXPECT_TRUE(owner.may_be_in_other_hands());
        EXPECT_FALSE(owner_of(file_)->owner.has_files);
        owner.settle();
        EXPECT_TRUE(owner_of(file_)->owner.has_files);
    }
    for (const bool has_files : {true, false}) {
        died.has_files = has_files;
        leave(died, 1);
        OwnerFile owner(file_, options("n1"));
        EXPECT_EQ(owner.is_claimed(), !has_files);
        owner.confirm();
        EXPECT_EQ(owner.may_be_in_other_hands(), !has_files);
    }
}

TEST_F(OwnerOf, AProcessOfThisHostThatIsNoMoreIsNotAlive) {
    EXPECT_FALSE(may_be_alive({{"n1", dead_process(), "", "", 0}, 1.0}, options("n1")));
    EXPECT_TRUE(may_be_alive({{"n1", ::getpid(), "", "", 0}, 1.0}, options("n1")));
    EXPECT_TRUE(may_be_alive({{"n2", 1, "", "", 0}, 59.0}, options("n1")));
    EXPECT_FALSE(may_be_alive({{"n2", 1, "", "", 0}, 61.0}, options("n1")));
}

TEST(OwnerText, IsReadAsWrittenAndHasOneLength) {
    const Owner owner{"n1", 17, "4711", "0123", 18'446'744'073'709'551'615U, 12};
    const Owner back = read_owner(owner_text(owner));
    EXPECT_EQ(back.host, owner.host);
    EXPECT_EQ(back.process, owner.process);
    EXPECT_EQ(back.job, owner.job);
    EXPECT_EQ(back.mark, owner.mark);
    EXPECT_EQ(back.count, owner.count);
    EXPECT_EQ(back.changes, owner.changes);
    EXPECT_TRUE(back.has_lock);
    EXPECT_TRUE(back.has_files);
    Owner other = owner;
    other.count = 0;
    other.has_lock = false;
    other.has_files = false;
    EXPECT_FALSE(read_owner(owner_text(other)).has_lock);
    EXPECT_FALSE(read_owner(owner_text(other)).has_files);
    EXPECT_EQ(owner_text(other).size(), owner_text(owner).size());
    EXPECT_EQ(read_owner("nonsense\n= =\nprocess = x").process, 0);
    other.host.assign(5000, 'h');
    other.job.assign(5000, 'j');
    EXPECT_LE(owner_text(other).size(), longest_owner_text);
}

TEST(OwnerText, SaysHowLongAgo) {
    EXPECT_EQ(ago_text(-1.0), "0 s ago");
    EXPECT_EQ(ago_text(75.0), "75 s ago");
    EXPECT_EQ(ago_text(600.0), "10 min ago");
    EXPECT_EQ(ago_text(3.0 * 3600.0), "3 h ago");
    EXPECT_EQ(ago_text(-600.0), "10 min from now");
    EXPECT_EQ(ago_text(-3.0 * 3600.0), "3 h from now");
}

}  // namespace
}  // namespace stridor::storage
