#include "stridor/io/atomic_file.hpp"

#include "stridor/base/check.hpp"
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

}  // namespace

std::string read_file(const std::string& path) {
    if (path == standard_input) return read_all(STDIN_FILENO, "standard input");
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) throw failure("read", path, errno);
    return read_all(file.number(), path);
}

/// Where the bytes of a file go before it has its name: a temporary beside it, or straight into a device or pipe.
class PiecewiseFile::Target {
public:
    explicit Target(const std::string& path) : path_(path) {
        struct stat status {};
        const bool exists = ::stat(path.c_str(), &status) == 0;
        if (exists && S_ISDIR(status.st_mode)) throw failure("write", path, EISDIR, "Name a file in it.");
        // renaming onto a device or a pipe would replace it
        if (exists && !S_ISREG(status.st_mode)) {
            file_.emplace(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
            if (!file_->is_open()) throw failure("write", path, errno);
            return;
        }
        std::error_code code;
        const std::filesystem::path resolved = std::filesystem::canonical(path, code);
        if (exists && !code) path_ = resolved.string();
        const std::string parent = std::filesystem::path(path_).parent_path().string();
        folder_ = parent.empty() ? "." : parent;
        auto [descriptor, name] = open_temporary(folder_, path_);
        temporary_.emplace(std::move(name));
        file_.emplace(descriptor);
        if (exists && ::fchmod(descriptor, status.st_mode & 07777U) != 0) throw failure("write", path_, errno);
    }

    void write(std::string_view bytes) const { write_all(file_->number(), bytes, path_); }

    void overwrite(std::uint64_t offset, std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = ::pwrite(file_->number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw failure("write", path_, errno);
            bytes.remove_prefix(static_cast<std::size_t>(count));
            offset += static_cast<std::uint64_t>(count);
        }
    }

    void commit() {
        if (temporary_) flush(file_->number(), path_);
        close(*file_, path_);
        if (!temporary_) return;
        if (::rename(temporary_->path().c_str(), path_.c_str()) != 0) throw failure("write", path_, errno);
        temporary_->keep();

        // the name itself is on the disk only once its folder is
        const Descriptor directory(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (!directory.is_open()) throw failure("write", path_, errno);
        flush(directory.number(), path_);
    }

private:
    std::string path_;
    std::string folder_;
    std::optional<Temporary> temporary_;  // nothing: straight into the device
    std::optional<Descriptor> file_;
};

PiecewiseFile::PiecewiseFile(const std::string& path) : target_(std::make_unique<Target>(path)) {}

PiecewiseFile::~PiecewiseFile() = default;

void PiecewiseFile::write(std::string_view bytes) {
    constexpr std::size_t block = 1U << 16U;
    size_ += bytes.size();
    if (pending_.size() + bytes.size() > block) {
        target_->write(pending_);
        pending_.clear();
    }
    if (bytes.size() > block)
        target_->write(bytes);
    else
        pending_ += bytes;
}

void PiecewiseFile::overwrite(std::uint64_t offset, std::string_view bytes) {
    STRIDOR_EXPECT(offset + bytes.size() <= size_);
    target_->write(pending_);
    pending_.clear();
    target_->overwrite(offset, bytes);
}

std::uint64_t PiecewiseFile::size() const {
    return size_;
}

void PiecewiseFile::commit() {
    target_->write(pending_);
    pending_.clear();
    target_->commit();
}

void write_file(const std::string& path, std::string_view bytes) {
    PiecewiseFile file(path);
    file.write(bytes);
    file.commit();
}

}  // namespace stridor::io
