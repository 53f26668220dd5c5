#include "stridor/storage/new_file.hpp"

#include "stridor/base/hash.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

namespace stridor::storage {

namespace fs = std::filesystem;

namespace {

std::string shown(const std::filesystem::path& path) {
    return "\"" + path.string() + "\"";
}

// what cannot be removed now is removed when the folder is made again
void remove_quietly(const std::filesystem::path& path) {
    std::error_code code;
    std::filesystem::remove_all(path, code);
}

constexpr std::string_view ending = ".tmp";

// "stridor-1f3a5b7c-": locks of another host may not be seen from here, so its files are left alone
std::string beginning() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    return "stridor-" + base::hash_text(host.data()).substr(0, 8) + "-";
}

// "123-0" between its beginning and its ending: process and number
bool is_of_a_process(std::string_view name, std::string_view begins, std::string_view ends) {
    if (!name.starts_with(begins) || !name.ends_with(ends) || name.size() < begins.size() + ends.size() + 3)
        return false;
    const std::string_view middle = name.substr(begins.size(), name.size() - begins.size() - ends.size());
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

// does a name still mean this open file? Its owner may have renamed it and begun another one of the same name
bool is_called(const struct stat& opened, const fs::path& name) {
    struct stat named {};
    return ::lstat(name.c_str(), &named) == 0 && named.st_ino == opened.st_ino && named.st_dev == opened.st_dev;
}

void remove_if_abandoned(const fs::path& file) {
    // a name may be anybody's: no link is followed and no pipe is waited for
    const Descriptor opened(::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!opened.is_open() || ::fstat(opened.number(), &status) != 0) return;
    const bool is_ours = S_ISREG(status.st_mode) && status.st_uid == ::geteuid() && status.st_nlink == 1;
    if (is_ours && try_lock(opened.number()) == Lock::taken && is_called(status, file)) ::unlink(file.c_str());
}

std::vector<fs::path> of_processes(const fs::path& folder, std::string_view begins, std::string_view ends) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
        if (is_of_a_process(each->path().filename().string(), begins, ends)) found.push_back(each->path());
    return found;
}

// a folder opened and locked; nothing where it is another's, or not the one of this name any more
std::optional<Descriptor> locked_folder(const fs::path& folder) {
    Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat status {};
    if (!opened.is_open() || ::fstat(opened.number(), &status) != 0 || status.st_uid != ::geteuid())
        return std::nullopt;
    if (::flock(opened.number(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
    return is_called(status, folder) ? std::optional(std::move(opened)) : std::nullopt;
}

Error lacks_folder(const fs::path& folder, const std::string& shown) {
    return system_failure("write", shown, ENOENT, "Create the folder \"" + folder.string() + "\" first.");
}

}  // namespace

void expect_folder_of(const fs::path& file) {
    const fs::path folder = file.parent_path();
    std::error_code error;
    if (!folder.empty() && fs::status(folder, error).type() == fs::file_type::not_found)
        throw lacks_folder(folder, file.string());
}

void remove_leftovers(const fs::path& folder) {
    const std::string begins = "." + beginning();
    for (const fs::path& each : of_processes(folder, begins, ending))
        remove_if_abandoned(each);
}

Temporary begin_temporary(const fs::path& folder, const std::string& shown) {
    const fs::path named = folder.empty() ? "." : folder;
    remove_leftovers(named);
    const std::string begins = "." + beginning() + std::to_string(::getpid()) + "-";
    for (int number = 0;; ++number) {
        fs::path name = named / (begins + std::to_string(number) + std::string(ending));
        Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file.is_open() && (errno == EEXIST || errno == EINTR)) continue;
        if (!file.is_open() && errno == ENOENT) throw lacks_folder(folder, shown);
        if (!file.is_open()) throw system_failure("write", shown, errno);
        // somebody may have taken it for abandoned before it was locked
        struct stat status {};
        const bool is_free = try_lock(file.number()) != Lock::held_by_another;
        if (!is_free || ::fstat(file.number(), &status) != 0 || !is_called(status, name)) continue;
        Descriptor lock(::fcntl(file.number(), F_DUPFD_CLOEXEC, 0));
        if (!lock.is_open()) {
            const int code = errno;
            ::unlink(name.c_str());
            throw system_failure("write", shown, code);
        }
        return {std::move(name), std::move(file), std::move(lock)};
    }
}

PrivateFolder::PrivateFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    const std::string begins = beginning();
    for (const fs::path& each : of_processes(parent, begins, ""))
        if (const std::optional<Descriptor> lock = locked_folder(each)) fs::remove_all(each, error);
    for (int number = 0;; ++number) {
        path_ = parent / (begins + std::to_string(::getpid()) + "-" + std::to_string(number));
        if (::mkdir(path_.c_str(), 0700) == 0) {
            std::optional<Descriptor> lock = locked_folder(path_);
            if (lock) lock_.emplace(std::move(*lock));
            // somebody may have taken it for abandoned before it was locked; some file systems know no locks
            if (lock_ || fs::exists(path_, error)) return;
        } else if (errno != EEXIST)
            throw system_failure("make a folder in", "\"" + parent.string() + "\"", errno,
                                 "Set TMPDIR to a folder with more room.");
    }
}

PrivateFolder::~PrivateFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
}

NewFile::NewFile(std::filesystem::path temporary, std::string shown)
    : temporary_(std::move(temporary)),
      shown_(std::move(shown)),
      descriptor_(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (!descriptor_.is_open()) throw system_failure("write", shown_, errno);
}

NewFile::NewFile(Temporary begun, std::string shown)
    : temporary_(std::move(begun.name)),
      shown_(std::move(shown)),
      descriptor_(std::move(begun.file)),
      lock_(std::move(begun.lock)) {}

NewFile::NewFile(NewFile&& other) noexcept
    : temporary_(std::exchange(other.temporary_, {})),
      shown_(std::move(other.shown_)),
      descriptor_(std::move(other.descriptor_)),
      lock_(std::move(other.lock_)),
      size_(other.size_) {}

NewFile::~NewFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void NewFile::write(std::string_view bytes) {
    write_all(descriptor_.number(), bytes, shown_);
    size_ += bytes.size();
}

void NewFile::finish() {
    flush(descriptor_.number(), shown_);
    descriptor_.close(shown_);
}

void NewFile::keep(const std::filesystem::path& name) {
    if (::rename(temporary_.c_str(), name.c_str()) != 0) throw system_failure("write", shown_, errno);
    temporary_.clear();
    flush_folder(name.parent_path(), shown_);
}

WholeFolder::WholeFolder(const std::filesystem::path& path)
    : path_(std::filesystem::absolute(path)),
      temporary_(path_.parent_path() / (".stridor-" + path_.filename().string() + ".tmp")) {
    remove_quietly(temporary_);
    std::error_code code;
    std::filesystem::create_directory(temporary_, code);
    if (code) throw system_failure("write", shown(path_), code.value());
}

WholeFolder::~WholeFolder() {
    if (!temporary_.empty()) remove_quietly(temporary_);
}

void WholeFolder::commit() {
    // its files are many: all that the disk's file system holds back is written at once
    const Descriptor folder(::open(temporary_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open() || ::syncfs(folder.number()) != 0) throw system_failure("write", shown(path_), errno);
    // the two change names at one stroke; not every file system can
    const bool has_changed = ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0;
    if (!has_changed) {
        remove_quietly(path_);
        if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw system_failure("write", shown(path_), errno);
    }
    flush_folder(path_.parent_path(), shown(path_));
    remove_quietly(temporary_);
    temporary_.clear();
}

}  // namespace stridor::storage
