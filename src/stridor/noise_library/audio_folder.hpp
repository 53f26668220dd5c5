#pragma once

#include "stridor/storage/new_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The audio of a library: a folder of files named by their content.
///
/// A file comes in four steps: it is written to `incoming` and flushed; the library's write lock is taken; the file is
/// renamed to its own name; the row that names it is committed. So a row never lacks its file. A process that dies in
/// between leaves a file without a row, and its marker: a file in `incoming` that lists what it was about to do, that
/// it had locked, and that the system unlocked. Whoever opens the library next finds a marker without an owner and
/// removes the audio it lists that no row has, under the write lock, where no living process can be between the last
/// two steps. No other audio is ever removed: it may belong to a newer copy of the database than the one at hand.
namespace stridor::noise_library {

/// Audio by its content.
struct AudioName {
    std::string hash;    // SHA-256, 64 hexadecimal digits
    std::string format;  // extension without its dot
    bool operator==(const AudioName&) const = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of its own comparison for a pointer
    auto operator<=>(const AudioName&) const = default;
};

/// Is it a digest and an extension, such as `format_of` gives?
bool is_audio_name(const AudioName& name);

/// "ab/abcdef....wav"; throws `Error` (io) for what is no audio name.
std::filesystem::path path_of(const AudioName& name);

/// The extension of a file as a library keeps it: lower case, at most eight letters and digits; "audio" if it has none.
std::string format_of(const std::filesystem::path& file);

/// A process' sign that it is changing the audio: a locked file that lists which. It stays behind, without its owner,
/// where the process dies, or where it ends between `announce` and `release`.
class Marker {
public:
    /// Makes the folders that are missing. Throws `Error` (io).
    explicit Marker(const std::filesystem::path& audio_folder);
    ~Marker();
    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    /// This audio may be left over from here on; on the disk when it returns.
    void announce(const std::set<AudioName>& names);

    /// Nothing is left over.
    void release() { is_held_ = false; }

    /// A new name for a temporary file of this process.
    std::filesystem::path temporary();

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    int temporaries_ = 0;
    bool is_held_ = false;
};

/// Gives the next bytes of a file in pieces, and nothing at its end.
using Pieces = std::function<std::string_view()>;

/// Audio that is on the disk and hashed, and not yet in its place.
struct Staged {
    AudioName name;
    std::uint64_t size = 0;  // [bytes]
    storage::NewFile file;
};

/// Brings audio in. What is staged and not placed is gone with it.
class Intake {
public:
    /// Brings it into this folder.
    explicit Intake(std::filesystem::path audio_folder);

    /// Copies audio and hashes it. Throws `Error` (io) where there is no room.
    Staged stage(const std::string& format, const Pieces& pieces);

    /// Gives those of the staged that are needed their names. Needs the library's write lock.
    void place(std::span<Staged> staged, const std::set<AudioName>& needed);

    /// The rows are committed.
    void settle() { marker_.release(); }

private:
    std::filesystem::path folder_;
    Marker marker_;
};

/// Are the bytes of a file those of its name? Throws `Error` (io) where it cannot be read.
bool is_whole(const std::filesystem::path& file, const AudioName& name);

/// Did a process die while it changed the audio?
bool has_leftovers(const std::filesystem::path& audio_folder);

/// Removes what dead processes left: temporary files, and audio they announced that no entry has. Needs the library's
/// write lock.
void clear_leftovers(const std::filesystem::path& audio_folder, const std::function<bool(const AudioName&)>& is_used);

/// The bytes of a file in pieces; throws `Error` (io) with what the user calls it.
class FilePieces {
public:
    /// Opens the file.
    explicit FilePieces(const std::filesystem::path& file);
    ~FilePieces();
    FilePieces(const FilePieces&) = delete;
    FilePieces& operator=(const FilePieces&) = delete;

    /// The next piece, valid until the next call; empty at the end.
    std::string_view operator()();

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    std::vector<char> block_;
};

}  // namespace stridor::noise_library
