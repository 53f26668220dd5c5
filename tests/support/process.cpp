#include "support/process.hpp"

#include "support/wait.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace stridor::support {

namespace {

void redirect(const std::filesystem::path& file, int flags, int descriptor) {
    const int opened = open(file.c_str(), flags, 0600);
    if (opened < 0) _exit(126);
    dup2(opened, descriptor);
    close(opened);
}

[[noreturn]] void become_program(const Launch& launch, const std::filesystem::path& output) {
    redirect(output / "in", O_RDONLY, STDIN_FILENO);
    redirect(output / "out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(output / "err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    if (!launch.folder.empty() && chdir(launch.folder.c_str()) != 0) _exit(126);
    if (launch.largest_file) {
        const rlimit limit{*launch.largest_file, *launch.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    for (const auto& [name, value] : launch.environment)
        setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> words;
    std::string path = launch.program.empty() ? program() : launch.program;
    words.push_back(path.data());
    std::vector<std::string> arguments = launch.arguments;
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    execv(path.c_str(), words.data());
    _exit(127);
}

}  // namespace

Process::Process(const Launch& launch) {
    write_text(output_ / "in", launch.input);
    id_ = fork();
    if (id_ == 0) become_program(launch, output_.path());
    if (id_ < 0) throw std::runtime_error("cannot fork");
}

Process::~Process() {
    if (!is_done_) {
        kill(id_, SIGKILL);
        waitpid(id_, &status_, 0);
    }
}

void Process::send(int signal) const {
    kill(id_, signal);
}

bool Process::is_running() {
    if (!is_done_) is_done_ = waitpid(id_, &status_, WNOHANG) == id_;
    return !is_done_;
}

bool Process::ends_within(std::chrono::duration<double> limit) {
    return wait_until([&] { return !is_running(); }, std::chrono::duration_cast<std::chrono::milliseconds>(limit));
}

bool Process::handles(int signal) const {
    std::ifstream status("/proc/" + std::to_string(id_) + "/status");
    const std::string name = "SigCgt:";
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name))
            return (std::stoull(line.substr(name.size()), nullptr, 16) >> (signal - 1) & 1U) != 0;
    return false;
}

std::string Process::err() const {
    return read_text(output_ / "err");
}

Finished Process::wait() {
    if (!is_done_) waitpid(id_, &status_, 0);
    is_done_ = true;
    Finished finished;
    if (WIFEXITED(status_)) finished.exit_code = WEXITSTATUS(status_);
    if (WIFSIGNALED(status_)) finished.signal = WTERMSIG(status_);
    finished.out = read_text(output_ / "out");
    finished.err = read_text(output_ / "err");
    return finished;
}

Finished run(const Launch& launch) {
    return Process(launch).wait();
}

Finished run(const std::vector<std::string>& arguments, const std::filesystem::path& folder, const std::string& input) {
    return run(Launch{arguments, folder, input, std::nullopt, {}});
}

bool run_and_kill(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                  std::chrono::milliseconds after) {
    Process process(Launch{arguments, folder, {}, std::nullopt, {}});
    process.ends_within(after);
    process.send(SIGKILL);
    return process.wait().signal == SIGKILL;
}

std::string program() {
    return STRIDOR_PROGRAM;
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
}

}  // namespace stridor::support
