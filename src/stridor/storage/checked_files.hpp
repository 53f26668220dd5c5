#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace stridor::storage {

/// What a database of ours says of itself in its header.
struct Identity {
    std::int32_t application_id = 0;  // 0: any database, unchecked
    std::int32_t first_checked = 1;   // layout ("user_version") from which on pages have checksums
};

/// What becomes of a page without its checksum.
enum class Damage {
    refuse,   // reading it fails
    salvage,  // it is read as it stands, for one who looks at each row himself
};

/// The files of one database connection, whose pages are given a checksum when they are written and are looked at when
/// they are read: a virtual file system of SQLite's ("VFS") before the system's own.
///
/// A database is checked if it is new or if two of three signs in its header say that it is ours: SQLite's words, the
/// application id, the reserved bytes. So one damaged sign does not turn the checks off. One of an older layout,
/// without reserved bytes, is not checked, and neither is another program's, whose header the caller looks at next.
///
/// Pages that come back from a rollback journal are looked at like those of the database.
class CheckedFiles {
public:
    /// What the files are, what becomes of a damaged page, and whether they are still this process's.
    ///
    /// `is_ours` is asked once a journal has been opened to be written, and before one is removed: a journal is known
    /// by its name, which may lead to that of another process by then. If it says no the call fails.
    CheckedFiles(const Identity& identity, Damage damage, std::function<bool()> is_ours = {});
    ~CheckedFiles();
    CheckedFiles(const CheckedFiles&) = delete;
    CheckedFiles& operator=(const CheckedFiles&) = delete;

    /// By which SQLite knows them.
    const char* name() const;

    /// Were the pages looked at, as far as the header was read?
    bool are_checked() const;

    struct System;

private:
    std::unique_ptr<System> system_;
};

}  // namespace stridor::storage
