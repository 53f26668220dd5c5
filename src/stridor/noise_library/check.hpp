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

/// Finding what is damaged in a library, and saving what is not.
namespace stridor::noise_library {

/// An entry that is there no more, or not as it was written, as far as an index still tells of it.
struct LostEntry {
    std::int64_t id = 0;
    std::string digest{};  // of all it said; may be empty
};

/// What the database of a library holds, damaged or not.
struct Saved {
    std::vector<Entry> entries;        // those that say what was written, by id
    std::vector<LostEntry> lost;       // by id
    std::int64_t last_id = 0;          // ids up to here were given
    std::vector<std::string> damages;  // of its pages and their structure, in words
};

/// A sound without the bytes of its name.
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

/// Was nothing found damaged or lost?
bool is_sound(const Findings& findings);

/// Looks at each page, each entry and each sound of a library. Changes nothing. Throws `Error` where it is none, or in
/// use.
Findings check(const std::filesystem::path& file, const LibraryOptions& options = {});

/// Sounds in the folder beside a library that none of these entries has, whole ones only.
std::vector<AudioName> sounds_without_entry(const std::filesystem::path& audio_folder, std::span<const Entry> entries);

/// Writes the database of a library anew with these entries, those without an id getting new ones beyond `last_id`.
/// The file as it was is kept beside it; its name is returned. Whoever calls sees to it that nobody uses the library
/// meanwhile, as far as that is possible with a damaged one.
std::filesystem::path replace_database(const std::filesystem::path& file, std::span<const Entry> entries,
                                       std::int64_t last_id);

/// What the database of a library holds, read from a copy where it is: a page without its checksum is read as it
/// stands, and each entry is held against its digest. A first page that lost its checksum is replaced by that of a new
/// library, whose tables begin at the same pages. Throws `Error` where it is no library, or in use.
Saved saved_from(const std::filesystem::path& file, const LibraryOptions& options);

}  // namespace stridor::noise_library
