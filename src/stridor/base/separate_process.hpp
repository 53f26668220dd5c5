#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace stridor::base {

/// Fills the bytes with the next ones that were sent; false where there are none any more. Throws `Error` (io) where
/// what was sent ends in between.
using Receive = std::function<bool(std::span<std::byte>)>;

/// Work in a copy of this process, for a library that may crash.
///
/// The copy has all of this process' memory and none of its threads: it may use what no other thread held when it
/// began. What it changes in memory is lost with it; it dies with this process. Its own destructors and exit handlers
/// do not run.
class SeparateProcess {
public:
    /// Begins the work. Errors begin with `problem`: "cannot write \"chart.nc\"". Throws `Error` (io).
    SeparateProcess(std::string problem, const std::function<void(const Receive&)>& work);
    /// Ends the process, finished or not.
    ~SeparateProcess();
    SeparateProcess(const SeparateProcess&) = delete;
    SeparateProcess& operator=(const SeparateProcess&) = delete;

    /// Gives it bytes. Throws `Error` (io) where it has failed.
    void send(std::span<const std::byte> bytes);

    /// Nothing more is sent: waits for the end of the work. Throws `Error` (io) with what it threw, or how it died.
    void finish();

private:
    int wait();
    [[noreturn]] void fail(int status) const;

    std::string problem_;
    int channel_ = -1;
    pid_t id_ = -1;
};

}  // namespace stridor::base
