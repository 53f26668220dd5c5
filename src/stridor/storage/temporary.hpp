#pragma once

#include "stridor/storage/system_io.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// Files that are not finished, and how to tell those of the dead from those of the living.
///
/// A temporary is called ".stridor-HOST-PROCESS-NUMBER.tmp" and is locked by whoever writes it, until it has its own
/// name. The system takes the lock from a process that dies, however it dies. So a file of such a name, of this host
/// and this user, that nobody has locked, was left behind and may go. Where a file system knows no locks nothing is
/// ever
/// removed.
namespace stridor::storage {

/// A new file under a temporary name. It is neither renamed nor removed by itself.
struct Temporary {
    std::filesystem::path name;
    Descriptor file;  // open for writing
    Descriptor lock;  // the same open file: keeps the lock while `file` is closed and renamed; to be closed after that
};

/// Begins a file in a folder, and removes what dead processes left there. Throws `Error` (io); `shown` is what it
/// calls the file.
Temporary begin_temporary(const std::filesystem::path& folder, const std::string& shown);

/// Throws `Error` (io) where the folder of a file that is to be written is not there.
void expect_folder_of(const std::filesystem::path& file);

/// Removes what dead processes left in a folder. What cannot be removed stays.
void remove_leftovers(const std::filesystem::path& folder);

/// A folder of this process where the system keeps temporary files (TMPDIR), for a file that another program needs by
/// name.
///
/// It is called "stridor-HOST-PROCESS-NUMBER", is locked likewise, and goes with all that is in it: at its end, or,
/// where the process dies, as soon as another one makes such a folder.
class PrivateFolder {
public:
    /// Throws `Error` (io).
    PrivateFolder();
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    /// Where it stands.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::optional<Descriptor> lock_;
};

}  // namespace stridor::storage
