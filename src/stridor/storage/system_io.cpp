#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace stridor::storage {

std::string reason_of(int code) {
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

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

void Descriptor::close(const std::string& shown) {
    // an interrupted call has closed it all the same
    if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) throw system_failure("write", shown, errno);
}

Error system_failure(const std::string& doing, const std::string& shown, int code, std::string suggestion) {
    return {ErrorKind::io, {"cannot " + doing + " " + shown, reason_of(code), std::move(suggestion)}};
}

void write_all(int descriptor, std::string_view bytes, const std::string& shown) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_failure("write", shown, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void flush(int descriptor, const std::string& shown) {
    while (::fsync(descriptor) != 0) {
        if (errno == EINTR) continue;
        // asked once more, the system may say that all is well: it has forgotten what it could not write
        if (errno != EINVAL && errno != ENOTSUP) throw system_failure("write", shown, errno);
        return;
    }
}

void flush_folder(const std::filesystem::path& folder, const std::string& shown) {
    const std::filesystem::path named = folder.empty() ? "." : folder;
    const Descriptor directory(::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!directory.is_open()) throw system_failure("write", shown, errno);
    flush(directory.number(), shown);
}

}  // namespace stridor::storage
