// A disk that fails at one chosen call: preloaded into a program (LD_PRELOAD), which knows nothing of it.
//
// Counted are the calls that create, write, shorten, flush, rename, remove or close what lies below a folder, whoever
// makes them: the program, SQLite or HDF5. The n-th fails, or it and all further ones. Settings come by the
// environment:
//   FAILING_BELOW   the folder; calls on anything else pass
//   FAILING_AT      n, from 1
//   FAILING_WITH    the number of the error (errno); 0: the call writes half of what it was given; below 0: instead of
//                   the call the process gets the signal of that number, and makes the call once SIGSTOP is over
//   FAILING_TIMES   how many calls from the n-th on fail
//   FAILING_REPORT  a file that gets a line for each call that failed ("rename /tmp/x/chart.csv")
// A machine of its own, on a disk whose locks end at it:
//   MACHINE_NAME    its name (gethostname)
//   MACHINE_LOCKS   "none": every lock of a file is got
// The calls themselves are made straight into the kernel, so that nothing is needed of the library that this hides. A
// full disk spares what needs no room (ENOSPC: opening what is there, removing, closing). Programs that this one
// starts are spared.

#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Settings {
    char below[PATH_MAX] = "";
    char report[PATH_MAX] = "";
    long at = 0;
    long times = 1;
    int error = 0;
    char machine[256] = "";
    bool has_locks = true;
};

Settings settings;
std::atomic<long> calls{0};

const char* text_of(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

__attribute__((constructor)) void begin() {
    std::snprintf(settings.below, sizeof settings.below, "%s", text_of("FAILING_BELOW"));
    std::snprintf(settings.report, sizeof settings.report, "%s", text_of("FAILING_REPORT"));
    settings.at = std::atol(text_of("FAILING_AT"));
    settings.times = std::atol(text_of("FAILING_TIMES"));
    settings.error = std::atoi(text_of("FAILING_WITH"));
    std::snprintf(settings.machine, sizeof settings.machine, "%s", text_of("MACHINE_NAME"));
    settings.has_locks = std::strcmp(text_of("MACHINE_LOCKS"), "none") != 0;
    unsetenv("LD_PRELOAD");
}

enum class Needs { nothing, room };  // of the disk
enum class Gives { success, bytes };

bool is_below(const char* path) {
    const std::size_t length = std::strlen(settings.below);
    return length > 0 && std::strncmp(path, settings.below, length) == 0 &&
           (path[length] == '/' || path[length] == '\0');
}

// an absolute path of what a descriptor or a relative path means; empty if there is none
void find_path(int folder, const char* name, char (&path)[2 * PATH_MAX]) {
    path[0] = '\0';
    if (name != nullptr && name[0] == '/') {
        std::snprintf(path, sizeof path, "%s", name);
        return;
    }
    char link[64];
    if (folder == AT_FDCWD)
        std::snprintf(link, sizeof link, "/proc/self/cwd");
    else
        std::snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
    const long size = syscall(SYS_readlinkat, AT_FDCWD, link, path, PATH_MAX);
    if (size < 0) return;
    path[size] = '\0';
    if (name != nullptr) std::snprintf(path + size, sizeof path - static_cast<std::size_t>(size), "/%s", name);
}

void report(const char* call, const char* path) {
    if (settings.report[0] == '\0') return;
    char line[3 * PATH_MAX];
    const int size = std::snprintf(line, sizeof line, "%s %s\n", call, path);
    const long file = syscall(SYS_openat, AT_FDCWD, settings.report, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) return;
    syscall(SYS_write, file, line, static_cast<std::size_t>(size));
    syscall(SYS_close, file);
}

// is it this call's turn to fail?
bool fails(const char* call, int folder, const char* name, Needs needs, Gives gives = Gives::success) {
    if (settings.at <= 0) return false;
    const int before = errno;
    char path[2 * PATH_MAX];
    find_path(folder, name, path);
    errno = before;
    if (!is_below(path)) return false;
    const bool is_possible = settings.error == 0        ? gives == Gives::bytes
                             : settings.error == ENOSPC ? needs == Needs::room
                                                        : true;
    if (!is_possible) return false;
    const long number = ++calls;
    if (number < settings.at || number - settings.at >= settings.times) return false;
    report(call, path);
    // this thread, so that it stops here
    if (settings.error < 0) syscall(SYS_tgkill, getpid(), syscall(SYS_gettid), -settings.error);
    if (settings.error == -SIGSTOP) {
        errno = before;
        return false;
    }
    errno = settings.error == 0 ? before : settings.error;
    return true;
}

bool makes_a_file(int flags) {
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

bool is_short() {
    return settings.error == 0;
}

}  // namespace

extern "C" {

int openat(int folder, const char* path, int flags, ...) {
    mode_t mode = 0;
    if (makes_a_file(flags)) {
        va_list list;
        va_start(list, flags);
        mode = va_arg(list, mode_t);
        va_end(list);
    }
    if (fails("open", folder, path, makes_a_file(flags) ? Needs::room : Needs::nothing)) return -1;
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

int openat64(int folder, const char* path, int flags, ...) __attribute__((alias("openat")));

int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if (makes_a_file(flags)) {
        va_list list;
        va_start(list, flags);
        mode = va_arg(list, mode_t);
        va_end(list);
    }
    return openat(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) __attribute__((alias("open")));

int close(int file) {
    const bool has_failed = fails("close", file, nullptr, Needs::nothing);
    const int error = errno;
    const long result = syscall(SYS_close, file);
    if (!has_failed) return static_cast<int>(result);
    // the file is gone all the same, as with Linux
    errno = error;
    return -1;
}

ssize_t write(int file, const void* bytes, std::size_t size) {
    if (fails("write", file, nullptr, Needs::room, Gives::bytes)) {
        if (!is_short()) return -1;
        size = size > 1 ? size / 2 : size;
    }
    return syscall(SYS_write, file, bytes, size);
}

ssize_t writev(int file, const iovec* pieces, int count) {
    if (fails("writev", file, nullptr, Needs::room, Gives::bytes)) {
        if (!is_short()) return -1;
        count = 1;
    }
    return syscall(SYS_writev, file, pieces, count);
}

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t offset) {
    if (fails("pwrite", file, nullptr, Needs::room, Gives::bytes)) {
        if (!is_short()) return -1;
        size = size > 1 ? size / 2 : size;
    }
    return syscall(SYS_pwrite64, file, bytes, size, offset);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) __attribute__((alias("pwrite64")));

int fsync(int file) {
    if (fails("fsync", file, nullptr, Needs::room)) return -1;
    return static_cast<int>(syscall(SYS_fsync, file));
}

int fdatasync(int file) {
    if (fails("fdatasync", file, nullptr, Needs::room)) return -1;
    return static_cast<int>(syscall(SYS_fdatasync, file));
}

int ftruncate64(int file, off64_t size) {
    if (fails("ftruncate", file, nullptr, Needs::room)) return -1;
    return static_cast<int>(syscall(SYS_ftruncate, file, size));
}

int ftruncate(int file, off_t size) __attribute__((alias("ftruncate64")));

// these give the error's number
int posix_fallocate64(int file, off64_t offset, off64_t size) {
    const int before = errno;
    const bool has_failed = fails("fallocate", file, nullptr, Needs::room);
    const int error = errno;
    errno = before;
    if (has_failed) return error;
    const long result = syscall(SYS_fallocate, file, 0, offset, size);
    const int reason = errno;
    errno = before;
    return result == 0 ? 0 : reason;
}

int posix_fallocate(int file, off_t offset, off_t size) __attribute__((alias("posix_fallocate64")));

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
    if (fails("rename", to_folder, to, Needs::room)) return -1;
    return static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
    return renameat2(from_folder, from, to_folder, to, 0);
}

int rename(const char* from, const char* to) {
    return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0);
}

int unlinkat(int folder, const char* path, int flags) {
    if (fails("unlink", folder, path, Needs::nothing)) return -1;
    return static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
}

int unlink(const char* path) {
    return unlinkat(AT_FDCWD, path, 0);
}

int fcntl64(int file, int command, ...) {
    va_list list;
    va_start(list, command);
    void* const argument = va_arg(list, void*);
    va_end(list);
    const bool is_lock = command == F_SETLK || command == F_SETLKW || command == F_OFD_SETLK || command == F_OFD_SETLKW;
    if (!settings.has_locks && is_lock) return 0;
    const long result = syscall(SYS_fcntl, file, command, argument);
    const bool is_question = command == F_GETLK || command == F_OFD_GETLK;
    if (!settings.has_locks && is_question && result == 0) static_cast<struct flock*>(argument)->l_type = F_UNLCK;
    return static_cast<int>(result);
}

int fcntl(int file, int command, ...) __attribute__((alias("fcntl64")));

int gethostname(char* name, std::size_t size) {
    if (settings.machine[0] == '\0') {
        utsname names{};
        if (uname(&names) != 0) return -1;
        std::snprintf(name, size, "%s", names.nodename);
        return 0;
    }
    std::snprintf(name, size, "%s", settings.machine);
    return 0;
}

int mkdir(const char* path, mode_t mode) {
    if (fails("mkdir", AT_FDCWD, path, Needs::room)) return -1;
    return static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

}  // extern "C"
