#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/check.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

/// Bringing a damaged noise library back from what is left of it, from its audio and from archives.
namespace stridor::io {

/// What a repair did.
struct Repair {
    std::size_t kept = 0;                  // [1] entries that were as they were written
    std::size_t from_archives = 0;         // [1] entries
    std::size_t from_sounds = 0;           // [1] entries that say what their sound tells, and nothing else
    std::vector<std::int64_t> lost{};      // ids that nothing was found for
    std::size_t mended_sounds = 0;         // [1]
    std::filesystem::path damaged_file{};  // where the database is kept as it was; empty if it was sound
    noise_library::Findings findings{};    // after the repair
};

/// Repairs a library. A sound one is left alone.
///
/// Entries that say what was written stay, under their ids. One that is lost comes back from an archive: under its id
/// where an index still has the digest of what it said, under a new one where its sound lies in the folder without an
/// entry. Sounds that then still have no entry get one by listening to them. Damaged or missing sounds come back from
/// the archives.
///
/// The library's name leads to the old or to the new database at any moment. Throws `Error` as `check` and
/// `import_library` do.
Repair repair_library(const std::filesystem::path& file, std::span<const std::filesystem::path> archives,
                      const noise_library::Probe& probe);

}  // namespace stridor::io
