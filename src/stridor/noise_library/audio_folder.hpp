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
/// between leaves a file without a row, and its marker: a file in `incoming` that lists the planned audio. The process
/// had locked it, and the system unlocked it. The next process that opens the library finds a marker without an owner
/// and removes the listed audio that no row has, under the write lock, when no living process can be between the last
/// two steps. No other audio is ever removed: it may belong to a newer copy of the database.
namespace stridor::noise_library {

/// Audio by its content.
struct AudioName {
    std::string hash;    // SHA-256, 64 hexadecimal digits
    std::string format;  // extension without its dot
    bool operator==(const AudioName&) const = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of its own comparison for a pointer
    auto operator<=>(const AudioName&) const = default;
};

/// Says whether it is a digest and an extension, such as `format_of` returns.
bool is_audio_name(const AudioName& name);

/// Returns "ab/abcdef....wav"; throws `Error` (io) for an invalid audio name.
std::filesystem::path path_of(const AudioName& name);

/// Returns the extension of a file as a library keeps it: lower case, at most eight letters and digits; "audio" if it
/// has none.
std::string format_of(const std::filesystem::path& file);

/// A process' sign that it is changing the audio: a locked file that lists the audio. It stays behind without its owner
/// if the process dies, or if the marker ends between `announce` and `release`.
class Marker {
public:
    /// Makes the missing folders. Throws `Error` (io).
    explicit Marker(const std::filesystem::path& audio_folder);
    ~Marker();
    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    /// Lists audio that may be left over from here on; the list is on the disk when this returns.
    void announce(const std::set<AudioName>& names);

    /// Declares that no audio is left over.
    void release() { is_held_ = false; }

    /// Returns a new name for a temporary file of this process.
    std::filesystem::path temporary();

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    int temporaries_ = 0;
    bool is_held_ = false;
};

/// Returns the next bytes of a file, and an empty piece at its end.
using Pieces = std::function<std::string_view()>;

/// Audio that is on the disk and hashed, but not in its place yet.
struct Staged {
    AudioName name;
    std::uint64_t size = 0;  // [bytes]
    storage::NewFile file;
};

/// Brings audio into a library. Staged audio that is not placed is removed at the end.
class Intake {
public:
    /// Brings audio into this folder.
    explicit Intake(std::filesystem::path audio_folder);

    /// Copies audio and hashes it. Throws `Error` (io) if there is no room.
    Staged stage(const std::string& format, const Pieces& pieces);

    /// Gives the needed ones of the staged files their names. Needs the library's write lock.
    void place(std::span<Staged> staged, const std::set<AudioName>& needed);

    /// Declares that the rows are committed.
    void settle() { marker_.release(); }

private:
    std::filesystem::path folder_;
    Marker marker_;
};

/// Says whether the bytes of a file match its name. Throws `Error` (io) if it cannot be read.
bool is_whole(const std::filesystem::path& file, const AudioName& name);

/// Says whether a process died while it changed the audio.
bool has_leftovers(const std::filesystem::path& audio_folder);

/// Removes the remains of dead processes: temporary files, and the audio they listed that no entry has. Needs the
/// library's write lock.
void clear_leftovers(const std::filesystem::path& audio_folder, const std::function<bool(const AudioName&)>& is_used);

/// Reads the bytes of a file in pieces; throws `Error` (io) with the user's name of the file.
class FilePieces {
public:
    /// Opens the file.
    explicit FilePieces(const std::filesystem::path& file);
    ~FilePieces();
    FilePieces(const FilePieces&) = delete;
    FilePieces& operator=(const FilePieces&) = delete;

    /// Returns the next piece, valid until the next call; empty at the end.
    std::string_view operator()();

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    std::vector<char> block_;
};

}  // namespace stridor::noise_library
