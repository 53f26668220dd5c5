#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace stridor::base {

/// What a confined process may use.
struct Confines {
    std::uint64_t memory = std::uint64_t{1} << 30U;  // [bytes] of addresses, on top of what this process has
    std::uint64_t processor_time = 60;               // [s] it is ended after so much
    int patience = 120;                              // [s] that this process waits for bytes
    unsigned openings = 0;                           // [1] how often it may open a file, for reading only
    int file = -1;                                   // descriptor that it gets; negative: none
};

/// Work in a copy of this process, for a library that may crash or be taken over.
///
/// The copy has all of this process' memory and none of its threads: it may use what no other thread held when it
/// began. What it changes in memory is lost with it. Its own destructors and exit handlers do not run. It ends with the
/// thread that began it.
///
/// A confined copy works on bytes that nobody vouches for. It has no descriptor but its end of a channel and one file.
/// It may read, write to the channel, take memory and open so many files for reading; every other system call fails: no
/// network, no program, no other process. Linux only (seccomp). What it crashes, hangs or answers is for the caller to
/// judge.
class ChildProcess {
public:
    /// The copy's end of the channel.
    class Channel {
    public:
        /// Takes an open descriptor, which stays the caller's.
        explicit Channel(int descriptor) : descriptor_(descriptor) {}
        /// Fills the bytes with the next ones that were sent; false where there are none any more. Throws `Error` (io)
        /// where what was sent ends in between.
        bool receive(std::span<std::byte> into) const;
        /// Ends the process where nobody listens any more.
        void send(std::span<const std::byte> bytes) const;

    private:
        int descriptor_;
    };

    /// What the copy does.
    using Work = std::function<void(const Channel&)>;

    /// Where a confined process finds its file.
    static constexpr const char* file_path = "/proc/self/fd/4";

    /// Begins the work, confined where `confines` says to what. Throws `Error` (io) where the system has no more
    /// processes.
    ChildProcess(const std::optional<Confines>& confines, const Work& work);
    /// Ends the process, finished or not.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Gives it bytes; false where it has ended.
    bool send(std::span<const std::byte> bytes);

    /// Fills the bytes with its next ones; false where it died, fell silent or ended before.
    bool receive(std::span<std::byte> into);

    /// Ends it and says how it ended: "it crashed (signal 11)".
    std::string ending();

    /// Did it never begin, because this machine confines no processes? Known after `ending`.
    bool was_not_confined() const { return was_not_confined_; }

    /// Nothing more is sent: waits for the end of the work. Returns what it threw, or how it died; empty: it is done.
    /// Of one that is not confined and sends nothing itself.
    std::string finish();

private:
    int wait();

    int channel_ = -1;
    int patience_ = 0;  // [s]
    pid_t id_ = -1;
    bool is_silent_ = false;
    bool was_not_confined_ = false;
};

}  // namespace stridor::base
