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
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stridor::support {

namespace {

void redirect(const char* file, int flags, int descriptor) {
    const int opened = open(file, flags, 0600);
    if (opened < 0) _exit(126);
    dup2(opened, descriptor);
    close(opened);
}

// strings as the system's calls take them; they last as long as these do
std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    for (std::string& string : strings)
        pointers.push_back(string.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> environment_with(const std::vector<std::pair<std::string, std::string>>& added) {
    std::map<std::string, std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string text = *variable;
        variables.emplace(text.substr(0, text.find('=')), text);
    }
    for (const auto& [name, value] : added)
        variables[name] = name + "=" + value;
    std::vector<std::string> texts;
    for (const auto& [name, text] : variables)
        texts.push_back(text);
    return texts;
}

// What the child needs is made before it is: another thread of this process may hold the heap's lock at the fork, and
// nobody in the child would ever let go of it. From then on it makes only calls that are safe there (POSIX, fork).
class Prepared {
public:
    Prepared(const Launch& launch, const std::filesystem::path& output)
        : folder_(launch.folder.string()),
          largest_file_(launch.largest_file),
          in_((output / "in").string()),
          out_((output / "out").string()),
          err_((output / "err").string()),
          words_{launch.program.empty() ? program() : launch.program},
          environment_(environment_with(launch.environment)) {
        words_.insert(words_.end(), launch.arguments.begin(), launch.arguments.end());
        arguments_ = pointers(words_);
        variables_ = pointers(environment_);
    }
    Prepared(const Prepared&) = delete;  // the pointers are to its own strings
    Prepared& operator=(const Prepared&) = delete;

    [[noreturn]] void become() const {
        redirect(in_.c_str(), O_RDONLY, STDIN_FILENO);
        redirect(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        if (!folder_.empty() && chdir(folder_.c_str()) != 0) _exit(126);
        if (largest_file_) {
            const rlimit limit{*largest_file_, *largest_file_};
            setrlimit(RLIMIT_FSIZE, &limit);
        }
        execve(arguments_[0], arguments_.data(), variables_.data());
        _exit(127);
    }

private:
    std::string folder_;
    std::optional<unsigned long> largest_file_;
    std::string in_;
    std::string out_;
    std::string err_;
    std::vector<std::string> words_;
    std::vector<std::string> environment_;
    std::vector<char*> arguments_;
    std::vector<char*> variables_;
};

}  // namespace

Process::Process(const Launch& launch) {
    write_text(output_ / "in", launch.input);
    const Prepared prepared(launch, output_.path());
    id_ = fork();
    if (id_ == 0) prepared.become();
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

bool Process::is_stopped() const {
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(id_) + "/task")) {
        const std::string stat = read_text(thread.path() / "stat");
        // "12 (stridor) T ...": the name may hold anything
        const std::size_t name = stat.rfind(") ");
        if (name == std::string::npos || stat[name + 2] != 'T') return false;
    }
    return true;
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
