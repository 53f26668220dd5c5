#include "stridor/storage/whole_folder.hpp"

#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace stridor::storage {

namespace {

std::string shown(const std::filesystem::path& path) {
    return "\"" + path.string() + "\"";
}

// what cannot be removed now is removed when the folder is made again
void remove_quietly(const std::filesystem::path& path) {
    std::error_code code;
    std::filesystem::remove_all(path, code);
}

}  // namespace

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
