#include "stridor/recordings/bytes.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace stridor::recordings {

namespace {

Error failure(const std::string& doing, const std::string& path, int code) {
    const std::string why = code == ENOENT   ? "no such file or folder"
                            : code == EISDIR ? "it is a folder"
                            : code == EACCES ? "permission denied"
                                             : std::generic_category().message(code);
    return {ErrorKind::io, {"cannot " + doing + " \"" + path + "\"", why, ""}};
}

// nothing where the system has an error
std::optional<std::size_t> read_all_at(int descriptor, std::uint64_t offset, std::span<char> into) {
    std::size_t done = 0;
    while (done < into.size()) {
        const ssize_t count =
            ::pread(descriptor, into.data() + done, into.size() - done, static_cast<off_t>(offset + done));
        if (count == 0) break;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

class File final : public Bytes {
public:
    File(int descriptor, std::uint64_t size, std::string path)
        : descriptor_(descriptor),
          size_(size),
          path_(std::move(path)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() override { ::close(descriptor_); }

    std::uint64_t size() const override { return size_; }

    std::size_t read_at(std::uint64_t offset, std::span<char> into) const override {
        // what is appended after opening does not count
        const std::uint64_t left = offset < size_ ? size_ - offset : 0;
        const auto count = read_all_at(descriptor_, offset, into.first(std::min<std::uint64_t>(into.size(), left)));
        if (!count) throw failure("read", path_, errno);
        return *count;
    }

    std::optional<int> descriptor() const override { return descriptor_; }

private:
    int descriptor_;
    std::uint64_t size_;
    std::string path_;
};

class InMemory final : public Bytes {
public:
    explicit InMemory(std::string content) : content_(std::move(content)) {}

    std::uint64_t size() const override { return content_.size(); }

    std::size_t read_at(std::uint64_t offset, std::span<char> into) const override {
        if (offset >= content_.size()) return 0;
        return content_.copy(into.data(), into.size(), offset);
    }

private:
    std::string content_;
};

std::shared_ptr<const Bytes> spooled(int descriptor, const std::string& path) {
    auto spool = std::make_shared<Spool>();
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0) return spool;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw failure("read", path, errno);
        spool->append({block.data(), static_cast<std::size_t>(count)});
    }
}

}  // namespace

std::shared_ptr<const Bytes> open_bytes(const std::string& path) {
    if (path == storage::standard_input) return spooled(STDIN_FILENO, "standard input");
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw failure("read", path, errno);
    struct stat status {};
    const bool is_known = ::fstat(descriptor, &status) == 0;
    if (is_known && S_ISREG(status.st_mode))
        return std::make_shared<File>(descriptor, static_cast<std::uint64_t>(status.st_size), path);
    try {
        auto spool = spooled(descriptor, path);
        ::close(descriptor);
        return spool;
    } catch (...) {
        ::close(descriptor);
        throw;
    }
}

std::shared_ptr<const Bytes> open_plain_bytes(const std::string& path) {
    // opening a pipe would wait for who writes into it
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) throw failure("read", path, errno);
    struct stat status {};
    const bool is_known = ::fstat(descriptor, &status) == 0;
    if (is_known && S_ISREG(status.st_mode))
        return std::make_shared<File>(descriptor, static_cast<std::uint64_t>(status.st_size), path);
    ::close(descriptor);
    throw Error(
        ErrorKind::io,
        {"cannot read \"" + path + "\"",
         is_known && S_ISDIR(status.st_mode) ? "it is a folder" : "it is a pipe or a device, which may never end", ""});
}

std::shared_ptr<const Bytes> bytes_of(std::string content) {
    return std::make_shared<InMemory>(std::move(content));
}

std::string text_at(const Bytes& bytes, std::uint64_t offset, std::size_t length) {
    const std::uint64_t left = offset < bytes.size() ? bytes.size() - offset : 0;
    std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(length, left)), '\0');
    text.resize(bytes.read_at(offset, text));
    return text;
}

Spool::Spool() : descriptor_(-1) {
    std::error_code code;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(code);
    shown_ = "a temporary file in \"" + folder.string() + "\"";
    descriptor_ = ::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600);
    if (descriptor_ >= 0) return;
    // any other failure than of a file system without such files is the disk's
    if (errno != EOPNOTSUPP && errno != EISDIR && errno != ENOENT && errno != EINVAL) throw failure("write", errno);
    // not every file system knows files without a name
    std::string name = (folder / "stridor-XXXXXX").string();
    descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) throw failure("write", errno);
    ::unlink(name.c_str());
}

Spool::~Spool() {
    ::close(descriptor_);
}

Error Spool::failure(const std::string& doing, int code) const {
    return storage::system_failure(doing, shown_, code, "Set TMPDIR to a folder with more room.");
}

void Spool::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw failure("write", errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
        size_ += static_cast<std::uint64_t>(count);
    }
}

std::size_t Spool::read_at(std::uint64_t offset, std::span<char> into) const {
    const std::optional<std::size_t> count = read_all_at(descriptor_, offset, into);
    if (!count) throw failure("read", errno);
    return *count;
}

}  // namespace stridor::recordings
