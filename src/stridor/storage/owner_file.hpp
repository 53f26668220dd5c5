#pragma once

#include "stridor/storage/waiting.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

/// Who fills a file, across the machines that see it.
///
/// Locks tell the processes of one machine apart; on a disk that several machines share they may not. So beside a store
/// that is being filled stands STORE.owner: host, process and job of the one who fills it, and how far he is. A thread
/// touches it every ten seconds. Who finds one of another host refuses while it is younger than a minute, by the clock
/// of the file system, and takes over when it is older. One of the own host is left to the store's lock.
///
/// It appears by `link`, which is atomic on NFS, too. Only one who holds STORE.owner.lock replaces or removes it,
/// made likewise, after a look at it: so of several who would take over one does. Every owner has a mark of his
/// own, by which he notices that he is one no longer: a machine may stand still for minutes and go on. What he may have
/// had in hand then is another matter (`hand_over`).
///
/// Nobody is waited for without a bound. A file that cannot be read, such as another user's, is told by its time alone.
/// One from the future, by a clock that was set back, is looked at for a minute: who lives touches it. What is no file
/// is refused at once.
///
/// On the same machine the file may be read meanwhile, without a lock and without keeping the owner waiting: he tells
/// when he begins to change it and when he has ended. What was read while `changes` was even and stayed the same is
/// what was there.
namespace stridor::storage {

class Draft;
struct OwnerLook;

/// One who fills a file.
struct Owner {
    std::string host;
    long process = 0;           // its id there
    std::string job;            // SLURM_JOB_ID; may be empty
    std::string mark;           // unlike that of any other
    std::uint64_t count = 0;    // [1] what he has done: of a store its cells
    std::uint64_t changes = 1;  // [1] twice the changes of the file that have ended; odd while one is going on
    bool has_lock = true;       // a lock of the file keeps his neighbours away, too
    bool has_files = true;      // what has its names is in nobody else's hands (`settle`)
};

/// An owner as others see him.
struct SeenOwner {
    Owner owner;
    double silence = 0.0;  // [s] since the last sign of life; below 0: that is yet to come, by the file system's clock
};

/// "process 123 of host n1, job 17"; "somebody unknown" of one whose name could not be read
std::string text_of(const Owner& owner);

/// "4 s ago", "3 min ago", "2 min from now"
std::string ago_text(double silence);

/// How owners meet each other.
struct OwnerOptions {
    std::string shown;                            // what errors call the file: "the store pair/chart.sqlite"
    std::string host;                             // empty: this one
    bool has_lock = true;                         // a lock of its own tells apart the processes of one host
    std::chrono::milliseconds heartbeat{10'000};  // between signs of life
    std::chrono::milliseconds patience{60'000};   // so long a silent owner of another host is waited for
    WaitOptions wait{};
};

/// The file that says who fills a file.
std::filesystem::path owner_file_of(const std::filesystem::path& file);

/// Who fills a file, dead or alive; nothing where nobody does.
std::optional<SeenOwner> owner_of(const std::filesystem::path& file);

/// Is it a process of the machine that this one runs on?
bool is_of_this_host(const Owner& owner);

/// May an owner still be at work? Not if he has been silent for too long, or is no process of this host any more.
bool may_be_alive(const SeenOwner& seen, const OwnerOptions& options = {});

/// Throws `Error` (io), with who, if somebody else may be filling the file: to be asked before it is read, where the
/// locks of another machine may not be seen.
void expect_not_filled(const std::filesystem::path& file, const OwnerOptions& options);

/// The claim to fill a file, held while it lives.
class OwnerFile {
public:
    /// Claims the file. Throws `Error` (io) if another host fills it, with who, and where no claim can be written; for
    /// a file without a lock likewise if another process of this host does. One that may only be read is not claimed.
    /// Takes two minutes at most, and milliseconds unless a claim comes from the future or another one is being made.
    OwnerFile(std::filesystem::path file, OwnerOptions options);

    /// Gives it back, if it is still its own.
    ~OwnerFile();
    OwnerFile(const OwnerFile&) = delete;
    OwnerFile& operator=(const OwnerFile&) = delete;

    /// To be called once the lock on the file is got: an owner of this host that is still named is none any more.
    /// Throws `Error` (io) if another host was quicker, or somebody has taken the file over since it was claimed.
    void confirm();

    /// Was it claimed? It is not where it is left to the lock, and where it may only be read.
    bool is_claimed() const { return is_own_; }

    /// Is it still this one's at this moment, or left to the lock? Whoever opens a file, asks this and only then writes
    /// into it, writes into none that another one has put in its place.
    bool may_change();

    /// Throws `Error` (io) if somebody else has taken the file over. Looks for itself where the last sign of life is
    /// long ago.
    void expect_own();

    /// Tells others how far this one is, with the next sign of life.
    void tell(std::uint64_t count);

    /// The file changes from now on, as it may do from the beginning. Throws `Error` (io) if that cannot be told, or
    /// somebody else has taken the file over.
    void begin_change();

    /// It does not until the next `begin_change`; tells how far this one is, too. Throws `Error` (io) if somebody else
    /// has taken the file over: what has changed since the beginning is not in his.
    void end_change();

    /// Whose claim was taken over, if any.
    const std::optional<SeenOwner>& replaced() const { return replaced_; }

    /// Might whoever filled the file before go on with it, out of reach of its lock?
    bool may_be_in_other_hands() const;

    /// It is in nobody else's hands any more: until then whoever takes over from this one has to see to that.
    void settle();

    /// Unlike that of any other claim.
    const std::string& mark() const { return self_.mark; }

private:
    enum class Neighbour { left_to_the_lock, replaced };
    enum class Standing { gone, left_to_the_lock, at_work, unclear, over };  // of a claim that is there

    void claim(Neighbour neighbour);
    Standing stand(const OwnerLook& look, Neighbour neighbour, Unchanged& named) const;
    bool replace(const Draft& draft, const OwnerLook& look, Unchanged& turned);
    bool beat();
    [[noreturn]] void fail_as_lost() const;
    void live(const std::stop_token& stop);

    std::filesystem::path file_;
    std::filesystem::path name_;
    OwnerOptions options_;
    Owner self_;
    std::optional<SeenOwner> replaced_;

    std::mutex mutex_;  // guards the members below
    std::condition_variable_any changed_;
    bool is_own_ = false;
    bool is_lost_ = false;
    std::uint64_t count_ = 0;
    std::uint64_t changes_ = 1;
    std::int64_t last_beat_ = 0;  // [ms] by a clock that goes on while the machine sleeps

    std::jthread heart_;  // last, so that it ends before what it uses
};

}  // namespace stridor::storage
