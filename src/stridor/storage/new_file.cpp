#include "stridor/storage/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace stridor::storage {

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

}  // namespace stridor::storage
