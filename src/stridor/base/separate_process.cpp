#include "stridor/base/separate_process.hpp"

#include "stridor/base/error.hpp"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

namespace stridor::base {

namespace {

constexpr int has_failed = 1;                 // exit status of a process that sent its reason
constexpr std::size_t longest_reason = 4096;  // [bytes] longer ones are cut

std::string message_of(int code) {
    return std::generic_category().message(code);
}

// bytes received; fewer than wanted at the end
std::size_t receive_all(int channel, std::span<std::byte> into) {
    std::size_t done = 0;
    while (done < into.size()) {
        const ssize_t count = ::recv(channel, into.data() + done, into.size() - done, 0);
        if (count == 0 || (count < 0 && errno != EINTR)) break;
        if (count > 0) done += static_cast<std::size_t>(count);
    }
    return done;
}

bool send_all(int channel, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // whoever has gone is no reason to die by SIGPIPE
        const ssize_t count = ::send(channel, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

[[noreturn]] void work_and_exit(int channel, const std::function<void(const Receive&)>& work) {
    std::string reason;
    try {
        work([channel](std::span<std::byte> into) {
            const std::size_t count = receive_all(channel, into);
            if (count > 0 && count < into.size())
                throw Error(ErrorKind::io, {"half of it", "the process that sent it died", ""});
            return count == into.size();
        });
        ::_exit(0);
    } catch (const Error& error) {
        reason = error.problem().why.empty() ? error.problem().what : error.problem().why;
    } catch (const std::exception& error) {
        reason = error.what();
    }
    send_all(channel, std::as_bytes(std::span(reason)));
    ::_exit(has_failed);
}

}  // namespace

SeparateProcess::SeparateProcess(std::string problem, const std::function<void(const Receive&)>& work)
    : problem_(std::move(problem)) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw Error(ErrorKind::io, {problem_, "no channel to another process: " + message_of(errno), ""});
    id_ = ::fork();
    const int code = errno;
    if (id_ == 0) {
        ::close(ends[0]);
        // half a work is of no use to anybody
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        work_and_exit(ends[1], work);
    }
    ::close(ends[1]);
    channel_ = ends[0];
    if (id_ > 0) return;
    ::close(channel_);
    throw Error(ErrorKind::io, {problem_, "no process of its own could be started: " + message_of(code), ""});
}

SeparateProcess::~SeparateProcess() {
    if (id_ > 0) {
        ::kill(id_, SIGKILL);
        wait();
    }
    ::close(channel_);
}

int SeparateProcess::wait() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR)
        continue;
    id_ = -1;
    return status;
}

void SeparateProcess::fail(int status) const {
    std::string reason;
    if (WIFEXITED(status) && WEXITSTATUS(status) == has_failed) {
        reason.resize(longest_reason);
        reason.resize(receive_all(channel_, std::as_writable_bytes(std::span(reason))));
    } else if (WIFSIGNALED(status)) {
        reason = "the process that writes it was ended by signal " + std::to_string(WTERMSIG(status)) +
                 ", as by a full disk";
    } else {
        reason = "the process that writes it ended too early";
    }
    throw Error(ErrorKind::io, {problem_, reason, "Make room, or write elsewhere."});
}

void SeparateProcess::send(std::span<const std::byte> bytes) {
    if (!send_all(channel_, bytes)) fail(wait());
}

void SeparateProcess::finish() {
    ::shutdown(channel_, SHUT_WR);
    const int status = wait();
    const bool is_done = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!is_done) fail(status);
}

}  // namespace stridor::base
