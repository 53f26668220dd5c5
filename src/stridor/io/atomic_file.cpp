#include "stridor/io/atomic_file.hpp"

#include "stridor/base/error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::io {

namespace {

std::string quoted(const std::string& text) {
    return "\"" + text + "\"";
}

std::string reason(int code) {
    switch (code) {
        case ENOSPC:
            return "the disk is full";
        case EDQUOT:
            return "the disk quota is used up";
        case EFBIG:
            return "it would be larger than files may be here";
        case EACCES:
        case EPERM:
            return "permission denied";
        case EROFS:
            return "the file system is read-only";
        case ENOENT:
            return "no such file or folder";
        case ENOTDIR:
            return "a part of its path is not a folder";
        case EISDIR:
            return "it is a folder";
        default:
            return std::generic_category().message(code);
    }
}

Error failure(const std::string& doing, const std::string& path, int code, std::string suggestion = "") {
    return {ErrorKind::io, {"cannot " + doing + " " + quoted(path), reason(code), std::move(suggestion)}};
}

/// An open file, closed on the way out.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }

    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }

    // closing may report a write that failed late; the descriptor is gone either way
    int close() { return ::close(std::exchange(number_, -1)); }

private:
    int number_;
};

/// Removes a file unless it was renamed.
class Temporary {
public:
    explicit Temporary(std::string path) : path_(std::move(path)) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    const std::string& path() const { return path_; }
    void keep() { path_.clear(); }

private:
    std::string path_;
};

std::string read_all(int descriptor, const std::string& path) {
    std::string content;
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0) return content;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw failure("read", path, errno);
        content.append(block.data(), static_cast<std::size_t>(count));
    }
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw failure("write", path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

// some file systems cannot flush (EINVAL, ENOTSUP): there the rename is all that can be had
void flush(int descriptor, const std::string& path) {
    if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP) throw failure("write", path, errno);
}

void close(Descriptor& file, const std::string& path) {
    if (file.close() != 0) throw failure("write", path, errno);
}

// a short name of its own, so that a long target name stays within what a folder allows
std::string temporary_name(const std::string& folder, int number) {
    return folder + "/.stridor-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp";
}

std::pair<int, std::string> open_temporary(const std::string& folder, const std::string& path) {
    for (int number = 0;; ++number) {
        std::string name = temporary_name(folder, number);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return {descriptor, std::move(name)};
        if (errno == EEXIST) continue;
        const bool lacks_folder = errno == ENOENT;
        throw failure("write", path, errno, lacks_folder ? "Create the folder " + quoted(folder) + " first." : "");
    }
}

using Make = std::function<void(const Sink& sink)>;

// small pieces are gathered: a system call each would cost more than making them
void write_pieces(int descriptor, const Make& make, const std::string& path) {
    constexpr std::size_t enough = std::size_t{1} << 18U;
    std::string gathered;
    make([&](std::string_view bytes) {
        gathered += bytes;
        if (gathered.size() < enough) return;
        write_all(descriptor, gathered, path);
        gathered.clear();
    });
    write_all(descriptor, gathered, path);
}

void write_directly(const std::string& path, const Make& make) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.is_open()) throw failure("write", path, errno);
    write_pieces(file.number(), make, path);
    close(file, path);
}

/// What a path names: the file to be replaced, or the name of a new one.
struct Target {
    std::string path;
    std::optional<mode_t> mode;  // of the file that is there
    bool is_regular = true;
};

Target target_of(const std::string& path) {
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) throw failure("write", path, EISDIR, "Name a file in it.");
    if (!exists) return {path, std::nullopt};
    std::error_code code;
    const std::filesystem::path resolved = std::filesystem::canonical(path, code);
    return {code ? path : resolved.string(), status.st_mode & 07777U, S_ISREG(status.st_mode)};
}

// `fill` is given the open temporary and its name
void replace(const std::string& target, const std::function<void(int descriptor, const std::string& temporary)>& fill,
             std::optional<mode_t> mode) {
    const std::string parent = std::filesystem::path(target).parent_path().string();
    const std::string folder = parent.empty() ? "." : parent;
    auto [descriptor, name] = open_temporary(folder, target);
    Temporary temporary(std::move(name));
    Descriptor file(descriptor);
    if (mode && ::fchmod(file.number(), *mode) != 0) throw failure("write", target, errno);
    fill(file.number(), temporary.path());
    flush(file.number(), target);
    close(file, target);
    if (::rename(temporary.path().c_str(), target.c_str()) != 0) throw failure("write", target, errno);
    temporary.keep();

    // the name itself is on the disk only once its folder is
    Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!directory.is_open()) throw failure("write", target, errno);
    flush(directory.number(), target);
}

}  // namespace

std::string read_file(const std::string& path) {
    if (path == standard_input) return read_all(STDIN_FILENO, "standard input");
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) throw failure("read", path, errno);
    return read_all(file.number(), path);
}

void write_file(const std::string& path, std::string_view bytes) {
    write_file(path, [bytes](const Sink& sink) { sink(bytes); });
}

void write_file(const std::string& path, const Make& make) {
    const Target target = target_of(path);
    // renaming onto a device or a pipe would replace it
    if (!target.is_regular) return write_directly(path, make);
    replace(
        target.path, [&](int descriptor, const std::string&) { write_pieces(descriptor, make, target.path); },
        target.mode);
}

void write_file_by_name(const std::string& path, std::size_t room,
                        const std::function<void(const std::string& temporary)>& make) {
    const Target target = target_of(path);
    if (!target.is_regular) throw failure("write", path, ESPIPE);
    replace(
        target.path,
        [&](int descriptor, const std::string& temporary) {
            if (const int code = ::posix_fallocate(descriptor, 0, static_cast<off_t>(room)); code != 0)
                throw failure("write", target.path, code);
            make(temporary);
        },
        target.mode);
}

}  // namespace stridor::io
