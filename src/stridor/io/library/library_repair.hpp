#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/check.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

/// Restores a damaged noise library from its intact entries, from its audio and from archives.
namespace stridor::io {

/// The result of a repair.
struct Repair {
    std::size_t kept = 0;                  // [1] entries that were as they were written
    std::size_t from_archives = 0;         // [1] entries
    std::size_t from_sounds = 0;           // [1] entries made from their sound alone
    std::vector<std::int64_t> lost{};      // ids without any source
    std::size_t mended_sounds = 0;         // [1]
    std::filesystem::path damaged_file{};  // the database as it was; empty if it was sound
    noise_library::Findings findings{};    // after the repair
};

/// Repairs a library. A sound one is left alone.
///
/// Intact entries stay, under their ids. A lost entry comes back from an archive: under its id if an index still has
/// the digest of its content, under a new one if its sound lies in the folder without an entry. A sound that then still
/// has no entry gets one by listening to it. Damaged or missing sounds come back from the archives.
///
/// At any moment the library's name leads to the old or to the new database. Throws `Error` as `check` and
/// `import_library` do.
Repair repair_library(const std::filesystem::path& file, std::span<const std::filesystem::path> archives,
                      const noise_library::Probe& probe);

}  // namespace stridor::io
