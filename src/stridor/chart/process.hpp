#pragma once

#include <string>
#include <vector>

namespace stridor::chart {

/// How a program ended and what it wrote.
struct ProcessResult {
    int exit_status = 0;   // [1] as of the program; 128 + signal if a signal ended it
    std::string output;    // bytes of its standard output
    std::string messages;  // its standard error
};

/// Runs a program found on PATH, without a shell, feeds it `input` and reads what it writes until it ends.
///
/// Input, output and messages flow at the same time, so none can block another; a program that ends before it has read
/// all its input does no harm (no SIGPIPE). Throws `Error` (io) where the program cannot be started.
ProcessResult run_process(const std::vector<std::string>& command, const std::string& input);

/// Is there an executable file of this name on PATH?
bool is_on_path(const std::string& program);

}  // namespace stridor::chart
