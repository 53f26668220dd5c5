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
/// Locks tell apart the processes of one machine; on a disk that several machines share they may fail. So beside a
/// store that is being filled stands STORE.owner: host, process and job of its owner, and how far the owner is. A
/// thread touches it every ten seconds. A process that finds an owner of another host refuses while that file is
/// younger than a minute, by the clock of the file system, and takes over when it is older. An owner of the same host
/// is left to the store's lock.
///
/// The file appears by `link`, which is atomic on NFS, too. Only the holder of STORE.owner.lock replaces or removes it.
/// That lock is made by `link` as well, and only after a look at it, so that only one of several takes over. Every
/// owner has a mark of its own. By this mark an owner notices that it has lost the file: a machine may stand still for
/// minutes and go on. `hand_over` deals with the change that it may have had in progress.
///
/// No wait is unbounded. A file that cannot be read, such as another user's, is judged by its time alone. A file from
/// the future, written before a clock was set back, is watched for a minute: a living owner touches it. A folder, link
/// or pipe in its place is refused at once.
///
/// On the same machine others may read the store meanwhile, without a lock and without delaying the owner: the owner
/// tells when it begins to change the file and when it has ended. If `changes` was even and the same before and after
/// reading, what was read is consistent.
namespace stridor::storage {

class Draft;
struct OwnerLook;

/// The process that fills a file.
struct Owner {
    std::string host;
    long process = 0;           // its id there
    std::string job;            // SLURM_JOB_ID; may be empty
    std::string mark;           // different from that of any other
    std::uint64_t count = 0;    // [1] what it has done: the cells of a store
    std::uint64_t changes = 1;  // [1] twice the changes of the file that have ended; odd while one is going on
    bool has_lock = true;       // a lock of the file keeps its neighbours away, too
    bool has_files = true;      // no other process has the files of this name open (`settle`)
};

/// An owner as others see it.
struct SeenOwner {
    Owner owner;
    double silence = 0.0;  // [s] since the last sign of life; below 0: it lies in the future by the file system's clock
};

/// Returns an owner in words: "process 123 of host n1, job 17"; "somebody unknown" if the name could not be read.
std::string text_of(const Owner& owner);

/// Returns a silence in words: "4 s ago", "3 min ago", "2 min from now".
std::string ago_text(double silence);

/// How owners meet each other.
struct OwnerOptions {
    std::string shown;                            // what errors call the file: "the store pair/chart.sqlite"
    std::string host;                             // empty: this one
    bool has_lock = true;                         // a lock of the file tells apart the processes of one host
    std::chrono::milliseconds heartbeat{10'000};  // between signs of life
    std::chrono::milliseconds patience{60'000};   // how long a silent owner of another host is waited for
    WaitOptions wait{};
};

/// Returns the name of the owner's file of a file.
std::filesystem::path owner_file_of(const std::filesystem::path& file);

/// Returns who fills a file, dead or alive, or `std::nullopt` if nobody does.
std::optional<SeenOwner> owner_of(const std::filesystem::path& file);

/// Says whether an owner is a process of this machine.
bool is_of_this_host(const Owner& owner);

/// Says whether an owner may still be at work. It is not if it has been silent for too long, or is a dead process of
/// this host.
bool may_be_alive(const SeenOwner& seen, const OwnerOptions& options = {});

/// Throws `Error` (io), with the owner's name, if another process may be filling the file. Call it before reading,
/// since the locks of another machine may be invisible.
void expect_not_filled(const std::filesystem::path& file, const OwnerOptions& options);

/// The claim to fill a file, held while it lives.
class OwnerFile {
public:
    /// Claims the file. Throws `Error` (io) with the owner's name if another host fills it, and if no claim can be
    /// written. A file without a lock is also refused if another process of this host fills it. A file that may only be
    /// read is not claimed. Takes two minutes at most, and milliseconds unless a claim comes from the future or another
    /// claim is being made.
    OwnerFile(std::filesystem::path file, OwnerOptions options);

    /// Gives the claim back, if it is still its own.
    ~OwnerFile();
    OwnerFile(const OwnerFile&) = delete;
    OwnerFile& operator=(const OwnerFile&) = delete;

    /// Confirms the claim once the lock on the file is held: then an owner of this host that is still named is dead.
    /// Throws `Error` (io) if another host was quicker, or if somebody has taken the file over since it was claimed.
    void confirm();

    /// Says whether the file was claimed. It is not if it is left to the lock, or if it may only be read.
    bool is_claimed() const { return is_own_; }

    /// Says whether the file still belongs to this owner, or is left to the lock. A process that opens the file, then
    /// asks this, and only then writes, never writes into a file that another process has put in its place.
    bool may_change();

    /// Throws `Error` (io) if another process has taken the file over. Looks at the owner's file itself if the last
    /// sign of life is long ago.
    void expect_own();

    /// Tells others the count of this owner, with the next sign of life.
    void tell(std::uint64_t count);

    /// Tells others that the file changes from now on, as it may since the claim. Throws `Error` (io) if that cannot be
    /// told, or if another process has taken the file over.
    void begin_change();

    /// Tells others that the file does not change until the next `begin_change`, and the count of this owner. Throws
    /// `Error` (io) if another process has taken the file over: the change since `begin_change` is not in the new
    /// owner's file.
    void end_change();

    /// Returns the owner whose claim was taken over, or `std::nullopt` if there was none.
    const std::optional<SeenOwner>& replaced() const { return replaced_; }

    /// Says whether the former owner might go on with the file, out of reach of its lock.
    bool may_be_in_other_hands() const;

    /// Declares that no other process has the file any more. Until then a process that takes over from this one must
    /// hand it over.
    void settle();

    /// Returns the mark of this claim, different from that of any other.
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
