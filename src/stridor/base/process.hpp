#pragma once

#include "stridor/base/error.hpp"

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace stridor::base {

/// How a program ended and what it complained of.
struct ProcessResult {
    int exit_status = 0;   // [1] the program's own; 128 + signal if a signal ended it
    std::string messages;  // its standard error
};

/// Runs a program found on PATH until it ends, without a shell.
///
/// The program has no input, its standard output is dropped, and its messages have the C locale. Throws `Error` (io) if
/// it cannot be started, or if it has not ended after `longest`; it is killed then. Without `longest` it may take any
/// time.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::optional<std::chrono::seconds>& longest = std::nullopt);

/// A running program found on PATH, started without a shell, whose output is read as it comes. It has no input, and its
/// messages have the C locale. A Ctrl-C in the terminal does not reach it.
class PipedProcess {
public:
    /// Starts the program. Throws `Error` (io) if it cannot be started.
    explicit PipedProcess(const std::vector<std::string>& command);
    /// Ends the program, if it is not over, and waits for it.
    ~PipedProcess();
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    /// Returns the descriptor from which its standard output is read.
    int output() const { return output_; }
    /// Returns the descriptor from which its standard error is read.
    int messages() const { return messages_; }
    /// Waits for its end. Returns its own exit status, 128 + signal if a signal ended it.
    int wait();

private:
    int output_ = -1;
    int messages_ = -1;
    pid_t id_ = -1;
};

/// Says whether PATH has an executable file of this name.
bool is_on_path(const std::string& program);

/// Returns the error (io) to throw if the system starts no more threads.
Error no_thread(const std::system_error& failure);

}  // namespace stridor::base
