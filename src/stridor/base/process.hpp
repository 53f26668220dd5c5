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
    int exit_status = 0;   // [1] as of the program; 128 + signal if a signal ended it
    std::string messages;  // its standard error
};

/// Runs a program found on PATH until it ends, without a shell.
///
/// It has nothing to read, what it writes to standard output is dropped, and its messages have the C locale. Throws
/// `Error` (io) where it cannot be started, and where it has not ended after `longest`, when it is killed; nothing: it
/// takes what it takes.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::optional<std::chrono::seconds>& longest = std::nullopt);

/// Is there an executable file of this name on PATH?
bool is_on_path(const std::string& program);

/// What to throw (io) where the system starts no more threads.
Error no_thread(const std::system_error& failure);

}  // namespace stridor::base
