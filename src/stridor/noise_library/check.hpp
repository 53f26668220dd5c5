#pragma once

#include "stridor/noise_library/audio_folder.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/library_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

/// Finds damage in a library, and saves the intact entries.
namespace stridor::noise_library {

/// An entry that is lost or changed, as far as an index still tells of it.
struct LostEntry {
    std::int64_t id = 0;
    std::string digest{};  // of all its content; may be empty
};

/// The content of a library's database, damaged or not.
struct Saved {
    std::vector<Entry> entries;        // those that are as they were written, by id
    std::vector<LostEntry> lost;       // by id
    std::int64_t last_id = 0;          // the highest id that was given
    std::vector<std::string> damages;  // of its pages and their structure, in words
};

/// A sound whose bytes do not match its name.
struct DamagedSound {
    AudioName name;
    std::vector<std::int64_t> entries{};  // that have it
    bool is_missing = false;
};

/// The state of a library.
struct Findings {
    Saved saved;
    std::size_t sounds = 0;  // [1] that entries have
    std::vector<DamagedSound> damaged_sounds;
};

/// Says whether nothing was found damaged or lost.
bool is_sound(const Findings& findings);

/// Checks each page, each entry and each sound of a library. Changes nothing. Throws `Error` if the file is not a
/// library, or is in use.
Findings check(const std::filesystem::path& file, const LibraryOptions& options = {});

/// Returns the whole sounds in the folder beside a library that none of these entries has.
std::vector<AudioName> sounds_without_entry(const std::filesystem::path& audio_folder, std::span<const Entry> entries);

/// Writes the database of a library anew with these entries; those without an id get new ones beyond `last_id`. The old
/// file is kept beside it under the returned name. The caller must ensure that nobody uses the library meanwhile, as
/// far as that is possible with a damaged one.
std::filesystem::path replace_database(const std::filesystem::path& file, std::span<const Entry> entries,
                                       std::int64_t last_id);

/// Returns the content of a library's database, read from a copy: a page without its checksum is read as it stands, and
/// each entry is compared with its digest. A first page without a valid checksum is replaced by that of a new library,
/// whose tables begin at the same pages. Throws `Error` if it is not a library, or is in use.
Saved saved_from(const std::filesystem::path& file, const LibraryOptions& options);

}  // namespace stridor::noise_library
