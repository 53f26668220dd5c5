#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace stridor::storage {

// Checksums of the pages of a database. The last bytes of each page, which SQLite does not use ("reserved bytes"), hold
// a checksum of the page's number and of the bytes before. A single changed bit always changes it; any other damage
// goes unnoticed in one case of 2^64. docs/formats/chart.md has the definition.

inline constexpr std::size_t page_size = 4096;   // [bytes]
inline constexpr std::size_t checksum_size = 8;  // [bytes] at the end of each page, the lowest first
inline constexpr std::size_t reserved_place =
    20;  // of the byte of a database that says how many bytes each page reserves

/// Returns the checksum of a page without its last bytes; pages count from 1.
std::uint64_t page_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

/// Writes the checksum into the page's end.
void put_checksum(std::span<std::uint8_t, page_size> page, std::uint32_t number);

/// Says whether the page holds its checksum.
bool has_checksum(std::span<const std::uint8_t, page_size> page, std::uint32_t number);

/// The identity of a database of ours, as its header states it.
struct Identity {
    std::int32_t application_id = 0;  // 0: any database, unchecked
    std::int32_t first_checked = 1;   // layout ("user_version") from which on pages have checksums
};

/// What happens to a page without its checksum.
enum class Damage {
    refuse,   // reading it fails
    salvage,  // it is read as it stands, for a caller that checks each row itself
};

/// The files of one database connection. Their pages get a checksum when they are written, and it is checked when they
/// are read: a virtual file system of SQLite's ("VFS") before the system's own.
///
/// A database is checked if it is new, or if two of three signs in its header say that it is ours: SQLite's words, the
/// application id, the reserved bytes. So one damaged sign does not turn the checks off. A database of an older layout,
/// without reserved bytes, is not checked, nor is another program's, whose header the caller examines next.
///
/// Pages from a rollback journal are checked like those of the database.
class CheckedFiles {
public:
    /// Takes the identity, what happens to a damaged page, and the test whether the files still belong to this process.
    ///
    /// `is_ours` is called when a journal has been opened for writing, and before one is removed: a journal is found by
    /// its name, which may lead to another process' journal by then. If it returns false the call fails.
    CheckedFiles(const Identity& identity, Damage damage, std::function<bool()> is_ours = {});
    ~CheckedFiles();
    CheckedFiles(const CheckedFiles&) = delete;
    CheckedFiles& operator=(const CheckedFiles&) = delete;

    /// Returns the name by which SQLite knows them.
    const char* name() const;

    /// Says whether the pages were checked, as far as the header was read.
    bool are_checked() const;

    struct System;

private:
    std::unique_ptr<System> system_;
};

}  // namespace stridor::storage
