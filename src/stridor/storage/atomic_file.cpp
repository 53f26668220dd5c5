#include "stridor/storage/atomic_file.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/storage/new_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::storage {

namespace {

std::string in_quotes(const std::string& text) {
    return "\"" + text + "\"";
}

Error failure(const std::string& doing, const std::string& path, int code, std::string suggestion = "") {
    return storage::system_failure(doing, in_quotes(path), code, std::move(suggestion));
}

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

// A pipe that nobody reads yet is waited for, with a bound; a signal ends the wait.
int open_device(const std::string& path, bool is_pipe) {
    constexpr int moments = 1000;
    constexpr timespec moment{0, 10'000'000};
    for (int waited = 0;; ++waited) {
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | (is_pipe ? O_NONBLOCK : 0));
        if (descriptor >= 0) {
            if (is_pipe) ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
            return descriptor;
        }
        if (errno != ENXIO || !is_pipe) throw failure("write", path, errno);
        if (waited == moments) throw failure("write", path, ENXIO, "Nobody reads this pipe: start its reader first.");
        if (::nanosleep(&moment, nullptr) != 0)
            throw Error(ErrorKind::interrupted, {"stopped while it waited for a reader of " + in_quotes(path),
                                                 "nothing has been written", "Run the same command again."});
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
            device_.emplace(open_device(path, S_ISFIFO(status.st_mode)));
            return;
        }
        std::error_code code;
        const std::filesystem::path resolved = std::filesystem::canonical(path, code);
        if (exists && !code) path_ = resolved.string();
        folder_ = std::filesystem::path(path_).parent_path();
        file_.emplace(storage::begin_temporary(folder_, in_quotes(path_)), in_quotes(path_));
        if (exists && ::fchmod(file_->number(), status.st_mode & 07777U) != 0) throw failure("write", path_, errno);
    }

    void write(std::string_view bytes) { storage::write_all(number(), bytes, in_quotes(path_)); }

    void overwrite(std::uint64_t offset, std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = ::pwrite(number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw failure("write", path_, errno);
            bytes.remove_prefix(static_cast<std::size_t>(count));
            offset += static_cast<std::uint64_t>(count);
        }
    }

    std::string temporary_name(std::uint64_t room) const {
        if (!file_) throw failure("write", path_, ESPIPE);
        int code = EINTR;
        while (code == EINTR)
            code = ::posix_fallocate(number(), 0, static_cast<off_t>(room));
        if (code != 0) throw failure("write", path_, code);
        return file_->temporary().string();
    }

    void commit() {
        if (device_) return device_->close(in_quotes(path_));
        file_->finish();
        file_->keep(path_);
    }

private:
    int number() const { return device_ ? device_->number() : file_->number(); }

    std::string path_;
    std::filesystem::path folder_;
    std::optional<storage::NewFile> file_;       // nothing: straight into the device
    std::optional<storage::Descriptor> device_;  // or pipe
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

void make_folder(const std::filesystem::path& folder, const std::string& suggestion) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(ErrorKind::io, {"cannot make the folder " + folder.string(), error.message(), suggestion});
}

void expect_ending(const std::string& option, const std::string& file,
                   std::initializer_list<std::string_view> endings) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
    std::string known;
    for (const std::string_view each : endings)
        known += (known.empty() ? "" : " or ") + std::string(each);
    throw Error(ErrorKind::input,
                {option + " " + file + " has an ending that says nothing", "the ending chooses the format: " + known,
                 "Name it " + std::filesystem::path(file).replace_extension(*endings.begin()).string() + "."});
}

}  // namespace stridor::storage
