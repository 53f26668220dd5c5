#include "stridor/base/child_process.hpp"

#include "stridor/base/error.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <exception>
#include <system_error>
#include <vector>

namespace stridor::base {

namespace {

// exit statuses
constexpr int has_thrown = 1;  // where it is not confined, it has sent why
constexpr int is_unheard = 2;
constexpr int is_not_confined = 3;

// descriptors of a confined process; 0, 1 and 2 lead nowhere
constexpr int channel_descriptor = 3;
constexpr int file_descriptor = 4;
constexpr unsigned known_descriptors = 5;

constexpr std::size_t longest_reason = 4096;  // [bytes] longer ones are cut

/// A system call that is allowed where its third argument has none of some bits.
struct Allowed {
    long call;
    std::uint32_t forbidden = 0;
};

constexpr std::array allowed_calls{Allowed{SYS_read},
                                   Allowed{SYS_write},
                                   Allowed{SYS_pread64},
                                   Allowed{SYS_lseek},
                                   Allowed{SYS_fstat},
                                   Allowed{SYS_newfstatat},
                                   Allowed{SYS_readlinkat},
#ifdef SYS_readlink  // newer architectures have the former alone
                                   Allowed{SYS_readlink},
#endif
                                   Allowed{SYS_openat, O_WRONLY | O_RDWR | O_CREAT | O_TRUNC},
                                   Allowed{SYS_flock},
                                   Allowed{SYS_mmap, PROT_EXEC},
                                   Allowed{SYS_mprotect, PROT_EXEC},
                                   Allowed{SYS_munmap},
                                   Allowed{SYS_mremap},
                                   Allowed{SYS_madvise},
                                   Allowed{SYS_brk},
                                   Allowed{SYS_futex},
                                   Allowed{SYS_clock_gettime},
                                   Allowed{SYS_getrandom},
                                   Allowed{SYS_rt_sigreturn},
                                   Allowed{SYS_exit},
                                   Allowed{SYS_exit_group}};

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // no process is confined
#endif

sock_filter statement(int code, std::uint32_t value) {
    return {static_cast<std::uint16_t>(code), 0, 0, value};
}

// goes on behind so many statements where true, where false
sock_filter jump(int code, std::uint32_t value, std::uint8_t if_true, std::uint8_t if_false) {
    return {static_cast<std::uint16_t>(code), if_true, if_false, value};
}

std::vector<sock_filter> filter() {
    constexpr std::uint32_t third_argument = offsetof(seccomp_data, args) + 2 * sizeof(std::uint64_t);  // its low half
    constexpr std::uint32_t refusal = SECCOMP_RET_ERRNO | EPERM;
    std::vector<sock_filter> program{statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
                                     jump(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
                                     statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)};
    for (const Allowed& allowed : allowed_calls) {
        program.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
        program.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(allowed.call), 0, 4));
        program.push_back(statement(BPF_LD | BPF_W | BPF_ABS, third_argument));
        program.push_back(jump(BPF_JMP | BPF_JSET | BPF_K, allowed.forbidden, 0, 1));
        program.push_back(statement(BPF_RET | BPF_K, refusal));
        program.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    }
    program.push_back(statement(BPF_RET | BPF_K, refusal));
    return program;
}

bool limit(__rlimit_resource resource, std::uint64_t most) {
    rlimit limits{};
    if (::getrlimit(resource, &limits) != 0) return false;
    // beyond the hard limit of processor time comes a signal that does not say why
    const std::uint64_t hard = resource == RLIMIT_CPU ? most + 1 : most;
    if (limits.rlim_max == RLIM_INFINITY || hard < limits.rlim_max) limits.rlim_max = hard;
    limits.rlim_cur = std::min<rlim_t>(most, limits.rlim_max);
    return ::setrlimit(resource, &limits) == 0;
}

// [bytes] of addresses that this process has; 0 where the system does not say
std::uint64_t addresses() {
    const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    std::array<char, 32> text{};
    const ssize_t length = ::read(file, text.data(), text.size());
    ::close(file);
    // the first number is of pages
    std::uint64_t pages = 0;
    if (length > 0) std::from_chars(text.data(), text.data() + length, pages);
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// leaves the channel, the file and three that lead nowhere
bool keep_descriptors(int channel, int file) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    // beyond all places that are filled below
    const int far_nowhere = ::fcntl(nowhere, F_DUPFD, 16);
    const int far_channel = ::fcntl(channel, F_DUPFD, 16);
    const int far_file = ::fcntl(file < 0 ? nowhere : file, F_DUPFD, 16);
    bool is_done = far_nowhere >= 0 && far_channel >= 0 && far_file >= 0;
    for (int standard = 0; standard < channel_descriptor; ++standard)
        is_done = is_done && ::dup2(far_nowhere, standard) == standard;
    is_done = is_done && ::dup2(far_channel, channel_descriptor) == channel_descriptor;
    is_done = is_done && ::dup2(far_file, file_descriptor) == file_descriptor;
    return is_done && ::syscall(SYS_close_range, known_descriptors, ~0U, 0U) == 0;
}

bool confine(const Confines& confines) {
    const std::uint64_t held = addresses();
    // a file that is opened takes a descriptor, and none is ever given back: closing is not allowed
    const bool is_limited = held > 0 && limit(RLIMIT_AS, held + confines.memory) &&
                            limit(RLIMIT_CPU, confines.processor_time) && limit(RLIMIT_FSIZE, 0) &&
                            limit(RLIMIT_CORE, 0) && limit(RLIMIT_NOFILE, known_descriptors + confines.openings);
    if (!is_limited || architecture == 0) return false;
    std::vector<sock_filter> statements = filter();
    const sock_fprog program{static_cast<unsigned short>(statements.size()), statements.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

// bytes received; fewer than wanted at the end
std::size_t receive_all(int channel, std::span<std::byte> into) {
    std::size_t done = 0;
    while (done < into.size()) {
        const ssize_t count = ::read(channel, into.data() + done, into.size() - done);
        if (count == 0 || (count < 0 && errno != EINTR)) break;
        if (count > 0) done += static_cast<std::size_t>(count);
    }
    return done;
}

// what this program does on a signal is not the business of a copy that is confined
bool enter(int channel, const Confines& confines) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXCPU})
        std::signal(signal, SIG_DFL);
    return keep_descriptors(channel, confines.file) && confine(confines);
}

[[noreturn]] void work_and_exit(int channel, pid_t parent, const std::optional<Confines>& confines,
                                const ChildProcess::Work& work) {
    // nobody hears what it answers to a process that has ended, and half a work is of no use
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(is_unheard);  // it ended before that was asked for
    if (confines && !enter(channel, *confines)) ::_exit(is_not_confined);
    const ChildProcess::Channel end(confines ? channel_descriptor : channel);
    std::string reason;
    try {
        work(end);
        ::_exit(0);
    } catch (const Error& error) {
        reason = error.problem().why.empty() ? error.problem().what : error.problem().why;
    } catch (const std::exception& error) {
        reason = error.what();
    }
    // a confined process has no words of its own that anybody should trust
    if (!confines) end.send(std::as_bytes(std::span(reason)));
    ::_exit(has_thrown);
}

}  // namespace

bool ChildProcess::Channel::receive(std::span<std::byte> into) const {
    const std::size_t count = receive_all(descriptor_, into);
    if (count > 0 && count < into.size())
        throw Error(ErrorKind::io, {"half of it", "the process that sent it died", ""});
    return count == into.size();
}

void ChildProcess::Channel::send(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) ::_exit(is_unheard);
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

ChildProcess::ChildProcess(const std::optional<Confines>& confines, const Work& work)
    : patience_(confines ? confines->patience : 0) {
    const auto failure = [](int code) {
        return Error(ErrorKind::io,
                     {"no process of its own could be started", std::generic_category().message(code), ""});
    };
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw failure(errno);
    const pid_t parent = ::getpid();
    id_ = ::fork();
    const int code = errno;
    if (id_ == 0) {
        ::close(ends[0]);
        work_and_exit(ends[1], parent, confines, work);
    }
    ::close(ends[1]);
    channel_ = ends[0];
    if (id_ > 0) return;
    ::close(channel_);
    throw failure(code);
}

ChildProcess::~ChildProcess() {
    ending();
    ::close(channel_);
}

bool ChildProcess::send(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // whoever has gone is no reason to die by SIGPIPE
        const ssize_t count = ::send(channel_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool ChildProcess::receive(std::span<std::byte> into) {
    while (!into.empty()) {
        pollfd waiting{channel_, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, patience_ * 1000);
        if (ready < 0 && errno == EINTR) continue;
        is_silent_ = ready == 0;
        if (ready <= 0) return false;
        const ssize_t count = ::recv(channel_, into.data(), into.size(), 0);
        if (count == 0 || (count < 0 && errno != EINTR)) return false;
        if (count > 0) into = into.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

std::string ChildProcess::ending() {
    if (id_ < 0) return "";
    // one that has closed its end is about to end by itself, and how it does is worth knowing
    pollfd channel{channel_, POLLRDHUP, 0};
    if (::poll(&channel, 1, 0) <= 0) ::kill(id_, SIGKILL);
    const int status = wait();
    if (is_silent_) return "it did not answer within " + std::to_string(patience_) + " s";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "it computed for too long";
    if (WIFSIGNALED(status)) return "it crashed (signal " + std::to_string(WTERMSIG(status)) + ")";
    was_not_confined_ = WEXITSTATUS(status) == is_not_confined;
    if (was_not_confined_) return "this machine confines no processes";
    return "it ended too early";
}

std::string ChildProcess::finish() {
    ::shutdown(channel_, SHUT_WR);
    std::string reason(longest_reason, '\0');
    reason.resize(receive_all(channel_, std::as_writable_bytes(std::span(reason))));
    const int status = wait();
    if (WIFSIGNALED(status))
        return "the process that writes it was ended by signal " + std::to_string(WTERMSIG(status)) +
               ", as by a full disk";
    if (WEXITSTATUS(status) == 0) return "";
    // what ends a process in the middle of its work, as a library may, says nothing, whatever number it leaves
    return WEXITSTATUS(status) == has_thrown && !reason.empty() ? reason : "the process that writes it ended too early";
}

int ChildProcess::wait() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR)
        continue;
    id_ = -1;
    return status;
}

}  // namespace stridor::base
