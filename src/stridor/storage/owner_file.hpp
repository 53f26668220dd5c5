#pragma once

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
/// own, by which he notices that he is one no longer: a machine may stand still for minutes and go on.
///
/// On the same machine the file may be read meanwhile, without a lock and without keeping the owner waiting: he tells
/// when he begins to change it and when he has ended. What was read while `changes` was even and stayed the same is
/// what was there.
namespace stridor::storage {

/// One who fills a file.
struct Owner {
    std::string host;
    long process = 0;           // its id there
    std::string job;            // SLURM_JOB_ID; may be empty
    std::string mark;           // unlike that of any other
    std::uint64_t count = 0;    // [1] what he has done: of a store its cells
    std::uint64_t changes = 1;  // [1] twice the changes of the file that have ended; odd while one is going on
};

/// An owner as others see him.
struct SeenOwner {
    Owner owner;
    double silence = 0.0;  // [s] since the last sign of life
};

/// "process 123 of host n1, job 17"
std::string text_of(const Owner& owner);

/// "4 s ago", "3 min ago"
std::string ago_text(double silence);

/// How owners meet each other.
struct OwnerOptions {
    std::string shown;                            // what errors call the file: "the store pair/chart.sqlite"
    std::string host;                             // empty: this one
    bool has_lock = true;                         // a lock of its own tells apart the processes of one host
    std::chrono::milliseconds heartbeat{10'000};  // between signs of life
    std::chrono::milliseconds patience{60'000};   // so long a silent owner of another host is waited for
};

/// The file that says who fills a file.
std::filesystem::path owner_file_of(const std::filesystem::path& file);

/// Who fills a file, dead or alive; nothing where nobody does.
std::optional<SeenOwner> owner_of(const std::filesystem::path& file);

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
    OwnerFile(std::filesystem::path file, OwnerOptions options);

    /// Gives it back, if it is still its own.
    ~OwnerFile();
    OwnerFile(const OwnerFile&) = delete;
    OwnerFile& operator=(const OwnerFile&) = delete;

    /// To be called once the lock on the file is got: an owner of this host that is still named is none any more.
    /// Throws `Error` (io) if another host was quicker.
    void confirm();

    /// Throws `Error` (io) if somebody else has taken the file over. Looks for itself where the last sign of life is
    /// long ago.
    void expect_own();

    /// Tells others how far this one is, with the next sign of life.
    void tell(std::uint64_t count);

    /// The file changes from now on, as it may do from the beginning. Throws `Error` (io) if that cannot be told.
    void begin_change();

    /// It does not until the next `begin_change`; tells how far this one is, too.
    void end_change();

    /// Whose claim was taken over, if any.
    const std::optional<SeenOwner>& replaced() const { return replaced_; }

private:
    enum class Neighbour { left_to_the_lock, replaced };

    void claim(Neighbour neighbour);
    bool beat();
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
