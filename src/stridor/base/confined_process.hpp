#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// Work on bytes that nobody vouches for, by a library that may crash or be taken over, in a copy of this process.
///
/// The copy has no descriptor but its end of a channel and one file. It may read, write to the channel, take memory and
/// open so many files for reading; every other system call fails: no network, no program, no other process. Linux only
/// (seccomp). What it crashes, hangs or answers is for the caller to judge.
///
/// The copy has none of this process' threads. Its own destructors and exit handlers do not run. It ends with the
/// thread that began it.
class ConfinedProcess {
public:
    /// The confined end of the channel.
    class Channel {
    public:
        /// Takes an open descriptor, which stays the caller's.
        explicit Channel(int descriptor) : descriptor_(descriptor) {}
        /// Fills the bytes; false where there are none any more.
        bool receive(std::span<std::byte> into) const;
        /// Ends the process where nobody listens any more.
        void send(std::span<const std::byte> bytes) const;

    private:
        int descriptor_;
    };

    /// Where the process finds its file.
    static constexpr const char* file_path = "/proc/self/fd/4";

    /// Begins the work. Throws `Error` (io) where the system has no more processes.
    ConfinedProcess(const Confines& confines, const std::function<void(const Channel&)>& work);
    /// Ends the process, finished or not.
    ~ConfinedProcess();
    ConfinedProcess(const ConfinedProcess&) = delete;
    ConfinedProcess& operator=(const ConfinedProcess&) = delete;

    /// Gives it bytes; that it has died is noticed by `receive`.
    void send(std::span<const std::byte> bytes);

    /// Fills the bytes with its next ones; false where it died, fell silent or ended before.
    bool receive(std::span<std::byte> into);

    /// Ends it and says how it ended: "it crashed (signal 11)".
    std::string ending();

    /// Did it never begin, because this machine confines no processes? Known after `ending`.
    bool was_not_confined() const { return was_not_confined_; }

private:
    int channel_ = -1;
    int patience_ = 0;  // [s]
    pid_t id_ = -1;
    bool is_silent_ = false;
    bool was_not_confined_ = false;
};

}  // namespace stridor::base
