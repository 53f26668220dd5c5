#include "stridor/base/process.hpp"

#include "stridor/base/check.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace stridor::base {

namespace {

[[noreturn]] void fail_to(const std::string& what, int reason) {
    throw Error(ErrorKind::io, {what, std::strerror(reason), ""});
}

// both ends of a pipe, closed at the end of the block
struct Pipe {
    std::array<int, 2> ends{-1, -1};  // to read from, to write to

    Pipe() {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail_to("no pipe to another program could be opened", errno);
    }
    ~Pipe() {
        for (int& end : ends)
            close(end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    static void close(int& end) {
        if (end >= 0) ::close(std::exchange(end, -1));
    }
};

// what posix_spawn needs, released at the end of the block
struct SpawnSettings {
    posix_spawn_file_actions_t actions{};
    posix_spawnattr_t attributes{};

    SpawnSettings() {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
};

// our environment, but messages in English
std::vector<std::string> plain_environment() {
    std::vector<std::string> variables{"LC_ALL=C.UTF-8"};
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        if (!text.starts_with("LC_") && !text.starts_with("LANG=") && !text.starts_with("LANGUAGE="))
            variables.emplace_back(text);
    }
    return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

// `output`: where its standard output goes; negative: nowhere, and a signal of the terminal reaches it as it does us
pid_t start(std::vector<std::string> command, int messages, int output = -1) {
    SpawnSettings settings;
    posix_spawn_file_actions_addopen(&settings.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output < 0)
        posix_spawn_file_actions_addopen(&settings.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    else
        posix_spawn_file_actions_adddup2(&settings.actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&settings.actions, messages, STDERR_FILENO);
    // the child starts with the signals a program expects, whatever this program blocks or ignores
    sigset_t none;
    sigemptyset(&none);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigmask(&settings.attributes, &none);
    posix_spawnattr_setsigdefault(&settings.attributes, &usual);
    const int group = output < 0 ? 0 : POSIX_SPAWN_SETPGROUP;
    posix_spawnattr_setflags(&settings.attributes,
                             static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | group));

    std::vector<std::string> variables = plain_environment();
    pid_t child = -1;
    const int error = posix_spawnp(&child, command.front().c_str(), &settings.actions, &settings.attributes,
                                   pointers(command).data(), pointers(variables).data());
    if (error != 0) fail_to(command.front() + " could not be started", error);
    return child;
}

using Clock = std::chrono::steady_clock;

// [ms] as `poll` takes them; -1: without end
int left_until(const std::optional<Clock::time_point>& deadline) {
    if (!deadline) return -1;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(*deadline - Clock::now());
    return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, std::numeric_limits<int>::max()));
}

// nothing where it has not ended at the deadline
std::optional<std::string> read_to_end(int end, const std::optional<Clock::time_point>& deadline) {
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        pollfd waiting{end, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, left_until(deadline));
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) return std::nullopt;
        const ssize_t count = ::read(end, buffer.data(), buffer.size());
        if (count > 0)
            text.append(buffer.data(), static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            return text;
    }
}

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail_to("another program could not be waited for", errno);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const std::optional<std::chrono::seconds>& longest) {
    STRIDOR_EXPECT(!command.empty());
    Pipe messages;
    const pid_t child = start(command, messages.ends[1]);
    Pipe::close(messages.ends[1]);
    // it has closed its end once it is over
    std::optional<std::string> said =
        read_to_end(messages.ends[0], longest ? std::optional(Clock::now() + *longest) : std::nullopt);
    if (!said) ::kill(child, SIGKILL);
    const int status = wait_for(child);
    if (!said)
        throw Error(ErrorKind::io, {command.front() + " did not end within " + std::to_string(longest->count()) + " s",
                                    "it was ended", ""});
    return {status, std::move(*said)};
}

PipedProcess::PipedProcess(const std::vector<std::string>& command) {
    STRIDOR_EXPECT(!command.empty());
    Pipe output;
    Pipe messages;
    id_ = start(command, messages.ends[1], output.ends[1]);
    output_ = std::exchange(output.ends[0], -1);
    messages_ = std::exchange(messages.ends[0], -1);
}

PipedProcess::~PipedProcess() {
    // with nobody to read, it ends at its next write, if the signal does not end it
    Pipe::close(output_);
    Pipe::close(messages_);
    if (id_ < 0) return;
    ::kill(id_, SIGTERM);
    constexpr int patience = 100;  // times 10 ms
    int status = 0;
    for (int k = 0; k < patience; ++k) {
        const pid_t ended = ::waitpid(id_, &status, WNOHANG);
        if (ended != 0 && !(ended < 0 && errno == EINTR)) return;
        ::usleep(10'000);
    }
    ::kill(id_, SIGKILL);
    ::waitpid(id_, &status, 0);
}

int PipedProcess::wait() {
    return wait_for(std::exchange(id_, -1));
}

bool is_on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    if (path == nullptr) return false;
    std::string_view rest = path;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::string folder(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (!folder.empty() && ::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

Error no_thread(const std::system_error& failure) {
    return {ErrorKind::io,
            {"the system starts no more threads", failure.code().message(),
             "Choose fewer --threads, or raise the limit of this user or container (ulimit -u)."}};
}

}  // namespace stridor::base
