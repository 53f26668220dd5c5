#include "stridor/chart/process.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

// the environment as POSIX declares it
extern char** environ;  // NOLINT(readability-identifier-naming)

namespace stridor::chart {

namespace {

[[noreturn]] void fail(const std::string& what, int reason) {
    throw Error(ErrorKind::io, {what, std::strerror(reason), ""});
}

// a file descriptor that closes itself
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    void close() {
        if (is_open()) ::close(std::exchange(number_, -1));
    }

private:
    int number_ = -1;
};

struct Channel {
    Descriptor ours;
    Descriptor theirs;
};

// sockets rather than pipes: MSG_NOSIGNAL keeps a reader that has gone from ending us by SIGPIPE
Channel open_channel() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        fail("no channel to another program could be opened", errno);
    return {Descriptor(ends[1]), Descriptor(ends[0])};
}

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

// our environment, but numbers with a point and no settings of the user's own
std::vector<std::string> plain_environment() {
    constexpr std::array<std::string_view, 5> dropped{"LC_", "LANG=", "LANGUAGE=", "GNUTERM=", "GNUPLOT_"};
    std::vector<std::string> variables{"LC_ALL=C.UTF-8"};
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        bool is_dropped = false;
        for (const std::string_view start : dropped)
            is_dropped = is_dropped || text.substr(0, start.size()) == start;
        if (!is_dropped) variables.emplace_back(text);
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

pid_t start(std::vector<std::string> command, const std::array<Channel, 3>& channels) {
    SpawnSettings settings;
    for (int i = 0; i < 3; ++i)
        posix_spawn_file_actions_adddup2(&settings.actions, channels[static_cast<std::size_t>(i)].theirs.number(), i);
    // the child starts with the signals a program expects, whatever this program blocks or ignores
    sigset_t none;
    sigemptyset(&none);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigmask(&settings.attributes, &none);
    posix_spawnattr_setsigdefault(&settings.attributes, &usual);
    posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    std::vector<std::string> variables = plain_environment();
    pid_t child = -1;
    const int error = posix_spawnp(&child, command.front().c_str(), &settings.actions, &settings.attributes,
                                   pointers(command).data(), pointers(variables).data());
    if (error != 0) fail(command.front() + " could not be started", error);
    return child;
}

void send_some(Descriptor& to, const std::string& input, std::size_t& sent) {
    const ssize_t count = ::send(to.number(), input.data() + sent, input.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0)
        sent += static_cast<std::size_t>(count);
    else if (errno != EAGAIN && errno != EINTR)
        sent = input.size();  // nobody reads any more; the exit status tells why
}

void receive_some(Descriptor& from, std::string& text) {
    std::array<char, 65536> buffer{};
    const ssize_t count = ::recv(from.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EAGAIN && errno != EINTR))
        from.close();
}

// passes bytes both ways until the program has closed its output and its messages
void exchange(std::array<Channel, 3>& channels, const std::string& input, ProcessResult& result) {
    std::size_t sent = 0;
    while (channels[1].ours.is_open() || channels[2].ours.is_open()) {
        if (sent == input.size()) channels[0].ours.close();
        std::array<pollfd, 3> waits{};
        for (std::size_t i = 0; i < waits.size(); ++i)
            waits[i] = {channels[i].ours.number(), static_cast<short>(i == 0 ? POLLOUT : POLLIN), 0};
        if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR)
            fail("another program could not be waited for", errno);
        if (waits[0].revents != 0) send_some(channels[0].ours, input, sent);
        if (waits[1].revents != 0) receive_some(channels[1].ours, result.output);
        if (waits[2].revents != 0) receive_some(channels[2].ours, result.messages);
    }
}

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail("another program could not be waited for", errno);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const std::string& input) {
    STRIDOR_EXPECT(!command.empty());
    std::array<Channel, 3> channels{open_channel(), open_channel(), open_channel()};
    const pid_t child = start(command, channels);
    for (Channel& channel : channels)
        channel.theirs.close();
    ProcessResult result;
    exchange(channels, input, result);
    result.exit_status = wait_for(child);
    return result;
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

}  // namespace stridor::chart
