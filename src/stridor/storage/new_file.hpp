#pragma once

#include "stridor/storage/system_io.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace stridor::storage {

// Unfinished files, and how to tell those of dead processes from those of living ones.
//
// A temporary file is called ".stridor-HOST-PROCESS-NUMBER.tmp" and is locked by its writer until it has its own name.
// The system releases the lock of a process that dies in any way. So a file of such a name, of this host and this user,
// that nobody has locked, was left behind and may be removed. On a file system without locks nothing is ever removed.

/// A new file under a temporary name. It is neither renamed nor removed by itself.
struct Temporary {
    std::filesystem::path name;
    Descriptor file;  // open for writing
    Descriptor lock;  // the same open file: keeps the lock while `file` is closed and renamed; to be closed after that
};

/// Begins a file in a folder, and removes the files that dead processes left there. Throws `Error` (io), which calls
/// the file `shown`.
Temporary begin_temporary(const std::filesystem::path& folder, const std::string& shown);

/// Throws `Error` (io) if the folder of a file to be written does not exist.
void expect_folder_of(const std::filesystem::path& file);

/// Removes the files that dead processes left in a folder. A file that cannot be removed stays.
void remove_leftovers(const std::filesystem::path& folder);

/// A folder of this process among the system's temporary files (TMPDIR), for a file that another program needs by name.
///
/// It is called "stridor-HOST-PROCESS-NUMBER" and is locked like a temporary file. It is removed with its content at
/// the end or, if the process dies, by the next process that makes such a folder.
class PrivateFolder {
public:
    /// Makes the folder. Throws `Error` (io).
    PrivateFolder();
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    /// Returns its path.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::optional<Descriptor> lock_;
};

/// A file that is written in pieces and has its name only once it is whole and on the disk.
///
/// It stands under a temporary name first, and is removed unless `keep` gives it its own. A failure throws `Error` (io)
/// with the name that the user knows and the reason.
class NewFile {
public:
    /// Begins a file under a temporary name that does not exist yet; errors call it `shown`.
    NewFile(std::filesystem::path temporary, std::string shown);
    /// Goes on with a temporary file that is already locked.
    NewFile(Temporary begun, std::string shown);
    ~NewFile();
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;

    /// Adds bytes at the end.
    void write(std::string_view bytes);

    /// Returns the descriptor, for a library that writes by itself.
    int number() const { return descriptor_.number(); }
    /// Returns its name until `keep`.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings everything to the disk and closes the file; nothing may be written afterwards.
    void finish();

    /// Renames the finished file, over another one if need be, and brings the folder to the disk.
    void keep(const std::filesystem::path& name);

    /// Returns the number of bytes written so far.
    std::uint64_t size() const { return size_; }  // [bytes]

private:
    std::filesystem::path temporary_;  // empty once it is renamed
    std::string shown_;
    Descriptor descriptor_;
    Descriptor lock_{-1};
    std::uint64_t size_ = 0;
};

/// A folder of files that appears under its name only as a whole and replaces an older one of that name. Without a
/// commit it leaves no trace. Only one process at a time may make a folder of a name.
class WholeFolder {
public:
    /// Begins an empty folder beside the name. Throws `Error` (io).
    explicit WholeFolder(const std::filesystem::path& path);
    ~WholeFolder();
    WholeFolder(const WholeFolder&) = delete;
    WholeFolder& operator=(const WholeFolder&) = delete;

    /// Returns its name until `commit`.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings the folder to the disk and gives it its name. Throws `Error` (io).
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

}  // namespace stridor::storage
