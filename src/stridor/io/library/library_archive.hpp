#pragma once

#include "stridor/io/library/tar.hpp"
#include "stridor/noise_library/library.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Noise libraries in one file, to hand to a colleague: a tar archive whose first file, manifest.jsonl, holds a line
/// per entry; the other files are the audio. The format is docs/formats/library.md.
namespace stridor::io {

/// Writes entries of a library, in their order, with their audio. The same entries give the same bytes.
///
/// Throws `Error` (io) if audio is missing or damaged, or the file cannot be written; then there is no file.
void export_library(const noise_library::Library& library, std::span<const noise_library::Entry> entries,
                    const std::filesystem::path& archive);

/// Returns the entries of an archive, without ids. Throws as `import_library` does.
std::vector<noise_library::Entry> archived_entries(const std::filesystem::path& archive);

/// Stages the wanted sounds that an archive has, whole, and returns them.
std::vector<noise_library::Staged> archived_audio(const std::filesystem::path& archive, noise_library::Intake& intake,
                                                  std::span<const noise_library::AudioName> wanted);

/// The result of an import.
struct Import {
    std::vector<std::int64_t> added{};  // ids
    std::size_t skipped = 0;            // entries that were there already, equal in all that people wrote
    std::size_t heard_otherwise = 0;    // of them, those with another verdict by ear, which stay unchanged
};

/// Adds the entries of an archive; all or none. An entry that the library has already is skipped, even if the verdicts
/// by ear differ: the library's stays.
///
/// Throws `Error` (input) for an archive that is not what it claims to be, (io) for one whose manifest does not match
/// its hash: then nothing of it stays. No name in it is ever used as a path. Memory grows with the number of audio
/// files alone.
Import import_library(noise_library::Library& library, const std::filesystem::path& archive,
                      const TarProgress& progress = {});

}  // namespace stridor::io
