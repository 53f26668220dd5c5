#pragma once

#include "support/scratch_folder.hpp"

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The program seen from outside: start it, talk to it, end it.
namespace stridor::support {

/// What a program left behind.
struct Finished {
    int exit_code = -1;  // -1 if a signal ended it
    int signal = 0;      // the signal that ended it
    std::string out;     // stdout
    std::string err;     // stderr
};

/// How to start it.
struct Launch {
    std::vector<std::string> arguments;
    std::filesystem::path folder;                                  // where it runs; empty: here
    std::string input;                                             // stdin
    std::optional<unsigned long> largest_file;                     // [bytes] RLIMIT_FSIZE, a disk that fills up
    std::vector<std::pair<std::string, std::string>> environment;  // added to ours
    std::string program{};                                         // another one than STRIDOR_PROGRAM
};

/// A running program; its output goes to files in a folder of its own, so that it never blocks on a pipe.
class Process {
public:
    explicit Process(const Launch& launch);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    pid_t id() const { return id_; }
    void send(int signal) const;
    bool is_running();
    /// Does it stand still (SIGSTOP), with all its threads?
    bool is_stopped() const;
    /// Waits for its end, at most so long: a kill later than that falls into its work.
    bool ends_within(std::chrono::duration<double> limit);
    /// Has it come to where it handles the signal itself?
    bool handles(int signal) const;
    /// What it has written so far to stderr.
    std::string err() const;
    Finished wait();

private:
    pid_t id_ = -1;
    int status_ = 0;
    bool is_done_ = false;
    ScratchFolder output_;
};

/// Runs the program (STRIDOR_PROGRAM) to its end.
Finished run(const std::vector<std::string>& arguments, const std::filesystem::path& folder = {},
             const std::string& input = {});
Finished run(const Launch& launch);

/// Starts it and kills it after so long, wherever in its work that is; false if it had ended before.
bool run_and_kill(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                  std::chrono::milliseconds after);

/// The program's path.
std::string program();

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace stridor::support
