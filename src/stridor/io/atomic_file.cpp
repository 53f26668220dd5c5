#include "stridor/io/atomic_file.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/storage/system_io.hpp"

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

std::string in_quotes(const std::string& text) {
    return "\"" + text + "\"";
}

Error failure(const std::string& doing, const std::string& path, int code, std::string suggestion = "") {
    return storage::system_failure(doing, in_quotes(path), code, std::move(suggestion));
}

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

// a short name of its own, so that a long target name stays within what a folder allows
std::string name_beside(const std::string& folder, int number) {
    return folder + "/.stridor-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp";
}

std::pair<int, std::string> open_temporary(const std::string& folder, const std::string& path) {
    for (int number = 0;; ++number) {
        std::string name = name_beside(folder, number);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return {descriptor, std::move(name)};
        if (errno == EEXIST) continue;
        const bool lacks_folder = errno == ENOENT;
        throw failure("write", path, errno, lacks_folder ? "Create the folder " + in_quotes(folder) + " first." : "");
    }
}

}  // namespace

std::string read_file(const std::string& path) {
    if (path == standard_input) return read_all(STDIN_FILENO, "standard input");
    const storage::Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
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

    void write(std::string_view bytes) const { storage::write_all(file_->number(), bytes, in_quotes(path_)); }

    void overwrite(std::uint64_t offset, std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = ::pwrite(file_->number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw failure("write", path_, errno);
            bytes.remove_prefix(static_cast<std::size_t>(count));
            offset += static_cast<std::uint64_t>(count);
        }
    }

    std::string temporary_name(std::uint64_t room) const {
        if (!temporary_) throw failure("write", path_, ESPIPE);
        if (const int code = ::posix_fallocate(file_->number(), 0, static_cast<off_t>(room)); code != 0)
            throw failure("write", path_, code);
        return temporary_->path();
    }

    void commit() {
        if (temporary_) storage::flush(file_->number(), in_quotes(path_));
        file_->close(in_quotes(path_));
        if (!temporary_) return;
        if (::rename(temporary_->path().c_str(), path_.c_str()) != 0) throw failure("write", path_, errno);
        temporary_->keep();

        // the name itself is on the disk only once its folder is
        storage::flush_folder(folder_, in_quotes(path_));
    }

private:
    std::string path_;
    std::string folder_;
    std::optional<Temporary> temporary_;  // nothing: straight into the device
    std::optional<storage::Descriptor> file_;
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

std::string PiecewiseFile::temporary_name(std::uint64_t room) {
    return target_->temporary_name(room);
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
