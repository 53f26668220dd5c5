#pragma once

#include "stridor/base/hash.hpp"
#include "stridor/io/library/tar.hpp"
#include "stridor/noise_library/audio_folder.hpp"
#include "stridor/noise_library/entry.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// The manifest of an archive of noise libraries: its first file, text with a JSON object per line.
/// docs/formats/library.md.
namespace stridor::io {

inline constexpr const char* manifest_name = "manifest.jsonl";

/// Returns the first line of a manifest of `entries` entries.
std::string manifest_opening(std::size_t entries);

/// Returns the line of an entry whose audio has `bytes` bytes.
std::string manifest_line(noise_library::Entry entry, std::uint64_t bytes);

/// Returns the last line: the hash of all lines before it.
std::string manifest_closing(std::string_view lines);

/// Throws `Error` (io) if an archive's manifest does not match the hash at its end. A manifest of the first schema has
/// none.
void expect_whole_manifest(TarReader& tar, const std::string& archive);

/// Returns the name of audio in an archive.
std::string archive_member(const noise_library::AudioName& audio);

/// An entry with the properties that its audio must have.
struct Announced {
    noise_library::Entry entry;
    std::uint64_t bytes = 0;
};

/// The entries of an untrusted archive, one by one.
///
/// All calls throw `Error` (input) for a text that is not a manifest: another first file, another schema, a line that
/// is too long or not an entry, a value that a user could not have written either.
class Manifest {
public:
    /// Goes to the archive's first file; `archive` is its name, for messages. The reader must outlive it.
    Manifest(TarReader& tar, const std::string& archive);
    ~Manifest();
    Manifest(const Manifest&) = delete;
    Manifest& operator=(const Manifest&) = delete;

    /// Returns the next entry, or `std::nullopt` after the last.
    std::optional<Announced> next();

    /// Returns the SHA-256 of the lines read, without the last one of a manifest with a hash; nothing may be read
    /// afterwards.
    std::string digest();

    class Lines;

private:
    std::unique_ptr<Lines> lines_;
    base::Sha256 hash_{};
    bool is_hashed_ = false;  // and the last line was not met
};

}  // namespace stridor::io
