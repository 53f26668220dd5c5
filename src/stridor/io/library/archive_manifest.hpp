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

/// The first line of a manifest of so many entries.
std::string manifest_opening(std::size_t entries);

/// The line of an entry whose audio has so many bytes.
std::string manifest_line(noise_library::Entry entry, std::uint64_t bytes);

/// The last line: the hash of all lines before it.
std::string manifest_closing(std::string_view lines);

/// Throws `Error` (io) where an archive's manifest has not the hash that it ends with. One of the first schema has
/// none.
void expect_whole_manifest(TarReader& tar, const std::string& archive);

/// Where in an archive audio stands.
std::string archive_member(const noise_library::AudioName& audio);

/// An entry with what its audio must be.
struct Announced {
    noise_library::Entry entry;
    std::uint64_t bytes = 0;
};

/// The entries of an archive, one by one, whoever made it.
///
/// Everything throws `Error` (input) for what is no manifest: another first file, another schema, a line that is too
/// long or no entry, a value that a user could not have written either.
class Manifest {
public:
    /// Goes to the archive's first file; `archive` is its name, for messages. The reader must outlive it.
    Manifest(TarReader& tar, const std::string& archive);
    ~Manifest();
    Manifest(const Manifest&) = delete;
    Manifest& operator=(const Manifest&) = delete;

    /// The next entry; nothing after the last.
    std::optional<Announced> next();

    /// SHA-256 of the lines read, but the last one of a manifest with a hash; nothing may be read afterwards.
    std::string digest();

    class Lines;

private:
    std::unique_ptr<Lines> lines_;
    base::Sha256 hash_{};
    bool is_hashed_ = false;  // and the last line was not met
};

}  // namespace stridor::io
