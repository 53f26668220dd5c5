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
    std::uint64_t processor_time = 60;               // [s] after which the copy is ended
    int patience = 120;                              // [s] that this process waits for bytes of the copy
    unsigned openings = 0;                           // [1] number of times the copy may open a file, for reading only
    int file = -1;                                   // descriptor that the copy receives; negative: none
};

/// Runs work in a copy of this process, for a library that may crash or be taken over.
///
/// The copy has all of this process' memory and none of its threads: it may use what no other thread held when it
/// began. What it changes in memory is lost with it. Its own destructors and exit handlers do not run. It ends with the
/// thread that began it.
///
/// A confined copy works on untrusted bytes. It has no descriptor but its end of a channel and one file. It may read,
/// write to the channel, take memory and open a limited number of files for reading. Every other system call fails: no
/// network, no program, no other process. Linux only (seccomp). The caller must judge the copy's crashes, silence and
/// answers.
class ChildProcess {
public:
    /// The copy's end of the channel.
    class Channel {
    public:
        /// Takes an open descriptor, which stays the caller's.
        explicit Channel(int descriptor) : descriptor_(descriptor) {}
        /// Fills `into` with the next bytes. Returns false if there are no more. Throws `Error` (io) if they end in
        /// between.
        bool receive(std::span<std::byte> into) const;
        /// Sends bytes. Ends the process if nobody listens any more.
        void send(std::span<const std::byte> bytes) const;

    private:
        int descriptor_;
    };

    /// The work of the copy.
    using Work = std::function<void(const Channel&)>;

    /// Path by which a confined process finds its file.
    static constexpr const char* file_path = "/proc/self/fd/4";

    /// Begins the work, confined if there are `confines`. Throws `Error` (io) if the system can start no more
    /// processes.
    ChildProcess(const std::optional<Confines>& confines, const Work& work);
    /// Ends the process, finished or not.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends bytes to the copy. Returns false if it has ended.
    bool send(std::span<const std::byte> bytes);

    /// Fills `into` with the copy's next bytes. Returns false if the copy died, fell silent or ended before.
    bool receive(std::span<std::byte> into);

    /// Ends the copy and returns how it ended: "it crashed (signal 11)".
    std::string ending();

    /// Says whether the work never began because this machine cannot confine a process. Known after `ending`.
    bool was_not_confined() const { return was_not_confined_; }

    /// Waits for the end of the work, after which nothing is sent. Returns what it threw or how it died, or an empty
    /// text if it is done. For a copy that is not confined and sends nothing.
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
