#include "stridor/storage/new_file.hpp"

#include "stridor/base/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace stridor::storage {

namespace {

std::string reason(int code) {
    switch (code) {
        case ENOSPC:
            return "the disk is full";
        case EDQUOT:
            return "the disk quota is used up";
        case EFBIG:
            return "it would be larger than files may be here";
        case EROFS:
            return "the file system is read-only";
        default:
            return std::generic_category().message(code);
    }
}

void write_all(int descriptor, std::string_view bytes, const std::string& shown) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_failure("write", shown, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void flush(int descriptor, const std::string& shown) {
    // some file systems cannot flush: there the rename is all that can be had
    if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP) throw_system_failure("write", shown, errno);
}

}  // namespace

void throw_system_failure(const std::string& doing, const std::string& what, int code) {
    throw Error(ErrorKind::io, {"cannot " + doing + " " + what, reason(code), ""});
}

NewFile::NewFile(std::filesystem::path temporary, std::string shown)
    : temporary_(std::move(temporary)),
      shown_(std::move(shown)),
      descriptor_(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (descriptor_ >= 0) return;
    const int code = errno;
    throw_system_failure("write", shown_, code);
}

NewFile::NewFile(NewFile&& other) noexcept
    : temporary_(std::exchange(other.temporary_, {})),
      shown_(std::move(other.shown_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

NewFile::~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void NewFile::write(std::string_view bytes) {
    write_all(descriptor_, bytes, shown_);
    size_ += bytes.size();
}

void NewFile::finish() {
    flush(descriptor_, shown_);
    // closing may report a write that failed late; the descriptor is gone either way
    if (::close(std::exchange(descriptor_, -1)) != 0) throw_system_failure("write", shown_, errno);
}

void NewFile::keep(const std::filesystem::path& name) {
    if (::rename(temporary_.c_str(), name.c_str()) != 0) throw_system_failure("write", shown_, errno);
    temporary_.clear();
    flush_folder(name.parent_path());
}

void write_and_flush(int descriptor, std::string_view bytes, const std::string& shown) {
    write_all(descriptor, bytes, shown);
    flush(descriptor, shown);
}

void flush_folder(const std::filesystem::path& folder) {
    const std::filesystem::path named = folder.empty() ? "." : folder;
    const int descriptor = ::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) throw_system_failure("write", named.string(), errno);
    const bool is_flushed = ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
    const int code = errno;
    ::close(descriptor);
    if (!is_flushed) throw_system_failure("write", named.string(), code);
}

}  // namespace stridor::storage
