#pragma once

#include "stridor/storage/system_io.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace stridor::storage {

// Files that are not finished, and how to tell those of the dead from those of the living.
//
// A temporary is called ".stridor-HOST-PROCESS-NUMBER.tmp" and is locked by whoever writes it, until it has its own
// name. The system takes the lock from a process that dies, however it dies. So a file of such a name, of this host
// and this user, that nobody has locked, was left behind and may go. Where a file system knows no locks nothing is ever
// removed.

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

/// A file that is written in pieces and has its name only once it is whole and on the disk.
///
/// It stands under a temporary name first, and is removed unless `keep` gave it its own. What fails throws `Error` (io)
/// with the name the user knows and the reason.
class NewFile {
public:
    /// Begins a file under a temporary name that does not exist yet; `shown` is what errors call it.
    NewFile(std::filesystem::path temporary, std::string shown);
    /// Goes on with one that is locked.
    NewFile(Temporary begun, std::string shown);
    ~NewFile();
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;

    /// Adds bytes at the end.
    void write(std::string_view bytes);

    /// The descriptor, for what writes by itself.
    int number() const { return descriptor_.number(); }
    /// The name it stands under until `keep`.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings everything to the disk and closes the file; nothing may be written afterwards.
    void finish();

    /// Renames the finished file, over another one if need be, and brings the folder to the disk.
    void keep(const std::filesystem::path& name);

    /// What was written so far.
    std::uint64_t size() const { return size_; }  // [bytes]

private:
    std::filesystem::path temporary_;  // empty once it is renamed
    std::string shown_;
    Descriptor descriptor_;
    Descriptor lock_{-1};
    std::uint64_t size_ = 0;
};

/// A folder of files that appears under its name only as a whole; what had the name before goes then. Gone without a
/// trace if it is never committed. One process at a time may make a folder of a name.
class WholeFolder {
public:
    /// Begins an empty one beside the name. Throws `Error` (io).
    explicit WholeFolder(const std::filesystem::path& path);
    ~WholeFolder();
    WholeFolder(const WholeFolder&) = delete;
    WholeFolder& operator=(const WholeFolder&) = delete;

    /// The name it has until then.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings it to the disk and gives it its name. Throws `Error` (io).
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

}  // namespace stridor::storage
