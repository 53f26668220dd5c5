// A process that fills a store stands still at any moment of a commit, for longer than it is waited for. Another
// machine takes over, on a disk whose locks end at the machine. When the first one wakes nothing is lost, whatever it
// goes on to write.
//
// STRIDOR_TAKEOVERS=64 does so more often, STRIDOR_TAKEOVERS_SEED=2 at other moments.

#include "determinism/swept_study.hpp"
#include "stridor/storage/owner_file.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/merge.hpp"
#include "stridor/sweep/store/share.hpp"
#include "support/counter_random.hpp"
#include "support/process.hpp"
#include "support/wait.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace stridor::sweep {
namespace {

namespace fs = std::filesystem;
using support::CounterRandom;
using support::Finished;
using support::Launch;
using support::Process;
using support::read_text;
using support::wait_until;

int number_in_environment(const char* name, int usual) {
    const char* const asked = std::getenv(name);
    return asked == nullptr ? usual : std::atoi(asked);
}

class Takeovers : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(shares_folder(folder_.path()));
        Store store(folder_ / "whole", study_);
        sweep::run(study_, store);
        cells_ = store.read();
    }

    // fills the store on a machine of this name; it stands still at the n-th call that changes a file
    Launch on(const std::string& machine, const fs::path& file = "", std::size_t call = 0) const {
        return {{store_.string(), "2", "0"},
                {},
                {},
                std::nullopt,
                {{"LD_PRELOAD", STRIDOR_FAILING_CALLS},
                 // which comes before the runtime of the address sanitizer
                 {"ASAN_OPTIONS", "strict_string_checks=1:verify_asan_link_order=0"},
                 {"MACHINE_NAME", machine},
                 {"MACHINE_LOCKS", "none"},
                 {"FAILING_BELOW", file.string()},
                 {"FAILING_AT", std::to_string(call)},
                 {"FAILING_TIMES", "1"},
                 {"FAILING_WITH", std::to_string(-SIGSTOP)},
                 {"FAILING_REPORT", report_.string()}}};
    }

    // one that stands still there; nothing if it came to its end before
    std::unique_ptr<Process> standing_still(const fs::path& file, std::size_t call) const {
        fs::remove(report_);
        auto process = std::make_unique<Process>(on("n1", file, call));
        EXPECT_TRUE(wait_until([&] { return !process->is_running() || fs::exists(report_); }));
        if (!process->is_running()) return nullptr;
        EXPECT_TRUE(wait_until([&] { return process->is_stopped(); }));
        return process;
    }

    std::optional<storage::Owner> owner() const {
        const std::optional<storage::SeenOwner> seen = storage::owner_of(store_);
        return seen ? std::optional(seen->owner) : std::nullopt;
    }

    // as if who fills the store had stood still for long
    void age_owner() const {
        const std::time_t then = std::time(nullptr) - 100;
        const timespec times[2] = {{then, 0}, {then, 0}};
        ASSERT_EQ(::utimensat(AT_FDCWD, storage::owner_file_of(store_).c_str(), times, 0), 0);
    }

    void expect_whole(const fs::path& file, const std::string& what) const {
        const std::vector<IndexedCell> found = Store(file, study_).read();
        ASSERT_EQ(found.size(), cells_.size()) << what;
        for (std::size_t k = 0; k < found.size(); ++k)
            ASSERT_TRUE(found[k].index == cells_[k].index && same_cell(found[k].cell, cells_[k].cell)) << k << what;
    }

    support::ScratchFolder folder_;
    Study study_ = swept_study(0);
    fs::path store_ = share_file(folder_.path(), {0, 1});
    fs::path report_ = folder_ / "report";
    std::vector<IndexedCell> cells_;  // of one that nobody disturbs
};

TEST_F(Takeovers, OfAProcessThatStandsStillWithinACommitLoseNothing) {
    const int wanted = number_in_environment("STRIDOR_TAKEOVERS", 8);
    CounterRandom random(static_cast<std::uint64_t>(number_in_environment("STRIDOR_TAKEOVERS_SEED", 1)));
    const std::string whole = std::to_string(cells_.size()) + "\n";
    int within = 0;
    for (int tries = 0; within < wanted; ++tries) {
        ASSERT_LT(tries, 8 * wanted) << "it hardly ever stands still within a commit";
        fs::remove_all(shares_folder(folder_.path()));
        fs::create_directories(shares_folder(folder_.path()));
        // what it is about to change: the database, its journal or any file
        const fs::path files[] = {store_, store_, store_.string() + "-journal", store_.parent_path()};
        const std::unique_ptr<Process> first = standing_still(files[random.below(4)], 1 + random.below(150));
        if (!first) continue;
        ++within;
        const std::optional<storage::Owner> former = owner();
        const std::size_t kept = former ? former->count : 0;
        const std::size_t moment = random.below(4);
        const std::string what = " at moment " + std::to_string(moment) + " after " + read_text(report_);
        if (former) age_owner();
        Process second(on("n2"));
        ASSERT_TRUE(wait_until([&] { return !second.is_running() || (owner() && owner()->host == "n2"); }));
        // the first wakes while the store is taken over, or is filled by the other; or that one is done, or dead
        if (moment == 1) wait_until([&] { return !second.is_running() || (owner() && owner()->changes > 3); });
        if (moment == 2) second.send(SIGKILL);
        if (moment >= 2) second.wait();
        first->send(SIGCONT);
        const Finished woken = first->wait();
        // it may have been about to make its claim, or to open a store that is whole by now
        const bool is_told = woken.err.find("is no longer this process's") != std::string::npos ||
                             woken.err.find("is in use (process ") != std::string::npos;
        const bool has_nothing_to_do = woken.exit_code == 0 && woken.out == "0\n";
        // or it had done all and given the store up, and was about to close its file
        const bool had_done_all = !former && woken.exit_code == 0 && woken.out == whole;
        EXPECT_TRUE(has_nothing_to_do || had_done_all || (woken.exit_code == 5 && is_told))
            << woken.exit_code << what << woken.err;
        Finished last = second.wait();
        if (moment == 2) {
            const bool is_neighbour = random.one_in(2);
            if (!is_neighbour && owner()) age_owner();
            last = support::run(on(is_neighbour ? "n2" : "n3"));
        }
        ASSERT_EQ(last.exit_code, 0) << what << last.err;
        if (moment != 2) {
            EXPECT_LE(std::stoul(last.out), had_done_all ? 0 : cells_.size() - kept) << what;
        }
        expect_whole(store_, what);
        EXPECT_EQ(std::distance(fs::directory_iterator(store_.parent_path()), fs::directory_iterator()), 1) << what;
    }
    RecordProperty("takeovers", within);
}

// a merge only reads: it leaves the store of one who stands still as it is
TEST_F(Takeovers, AMergeBesideOneWhoStandsStillDisturbsNobody) {
    const std::unique_ptr<Process> first = standing_still(store_, 40);
    ASSERT_TRUE(first);
    const std::size_t kept = owner()->count;
    age_owner();
    const MergeReport report = merge(study_, folder_.path());
    EXPECT_EQ(report.cells, kept) << "what the commit would add is not there";
    EXPECT_EQ(owner()->host, "n1");
    first->send(SIGCONT);
    const Finished woken = first->wait();
    EXPECT_EQ(woken.exit_code, 0) << woken.err;
    EXPECT_EQ(woken.out, std::to_string(cells_.size()) + "\n");
    expect_whole(store_, "");
    EXPECT_EQ(merge(study_, folder_.path()).cells, cells_.size());
}

}  // namespace
}  // namespace stridor::sweep
