#pragma once

#include "stridor/base/error.hpp"

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

/// Says whether PATH has an executable file of this name.
bool is_on_path(const std::string& program);

/// Returns the error (io) to throw if the system starts no more threads.
Error no_thread(const std::system_error& failure);

}  // namespace stridor::base
