#include "stridor/storage/temporary.hpp"

#include "stridor/base/hash.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace stridor::storage {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view ending = ".tmp";

// ".stridor-1f3a5b7c-": locks of another host may not be seen from here, so its files are left alone
std::string beginning() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    return ".stridor-" + base::hash_text(host.data()).substr(0, 8) + "-";
}

bool is_temporary_name(const std::string& name, const std::string& begins) {
    if (!name.starts_with(begins) || !name.ends_with(ending) || name.size() < begins.size() + ending.size() + 3)
        return false;
    // "123-0": process and number
    const std::string_view middle =
        std::string_view(name).substr(begins.size(), name.size() - begins.size() - ending.size());
    const auto is_allowed = [](char c) { return c == '-' || (c >= '0' && c <= '9'); };
    return std::all_of(middle.begin(), middle.end(), is_allowed) &&
           std::count(middle.begin(), middle.end(), '-') == 1 && middle.front() != '-' && middle.back() != '-';
}

enum class Lock { taken, held_by_another, unknown };

// a lock of the open file, not of the process: it lasts until the last descriptor of it is closed, and HDF5's own
// locks know nothing of it
Lock try_lock(int descriptor) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    if (::fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return Lock::taken;
    return errno == EAGAIN || errno == EACCES ? Lock::held_by_another : Lock::unknown;
}

bool has_name(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

void remove_if_abandoned(const fs::path& file) {
    // a name may be anybody's: no link is followed and no pipe is waited for
    const Descriptor opened(::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!opened.is_open() || ::fstat(opened.number(), &status) != 0) return;
    const bool is_ours = S_ISREG(status.st_mode) && status.st_uid == ::geteuid() && status.st_nlink == 1;
    if (is_ours && try_lock(opened.number()) == Lock::taken) ::unlink(file.c_str());
}

}  // namespace

void remove_leftovers(const fs::path& folder) {
    const std::string begins = beginning();
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
        if (is_temporary_name(each->path().filename().string(), begins)) remove_if_abandoned(each->path());
}

Temporary begin_temporary(const fs::path& folder, const std::string& shown) {
    const fs::path named = folder.empty() ? "." : folder;
    remove_leftovers(named);
    const std::string begins = beginning() + std::to_string(::getpid()) + "-";
    for (int number = 0;; ++number) {
        fs::path name = named / (begins + std::to_string(number) + std::string(ending));
        Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file.is_open() && (errno == EEXIST || errno == EINTR)) continue;
        if (!file.is_open()) {
            const std::string suggestion =
                errno == ENOENT ? "Create the folder \"" + folder.string() + "\" first." : "";
            throw system_failure("write", shown, errno, suggestion);
        }
        // somebody may have taken it for abandoned before it was locked
        if (try_lock(file.number()) == Lock::held_by_another || !has_name(file.number())) continue;
        Descriptor lock(::fcntl(file.number(), F_DUPFD_CLOEXEC, 0));
        if (!lock.is_open()) {
            const int code = errno;
            ::unlink(name.c_str());
            throw system_failure("write", shown, code);
        }
        return {std::move(name), std::move(file), std::move(lock)};
    }
}

}  // namespace stridor::storage
