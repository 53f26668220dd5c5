#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace stridor::storage {

// Checksums of the pages of a database: the last bytes of each page, which SQLite leaves to others ("reserved
// bytes"), hold a checksum of the page's number and of the bytes before. A changed bit changes it for certain,
// anything else but for one case in 2^64. docs/formats/chart.md has the definition.

inline constexpr std::size_t page_size = 4096;   // [bytes]
inline constexpr std::size_t checksum_size = 8;  // [bytes] at the end of each page, the lowest first
inline constexpr std::size_t reserved_place =
    20;  // of the byte of a database that says how many bytes each page reserves

/// The checksum of a page but its last bytes; pages count from 1.
std::uint64_t page_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

/// Writes the checksum into the page's end.
void put_checksum(std::span<std::uint8_t, page_size> page, std::uint32_t number);

/// Does the page hold its checksum?
bool has_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

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
