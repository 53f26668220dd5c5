#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// Does a name end as those of sound files do: ".wav", ".flac"? In either case of its letters.
bool has_sound_name(std::string_view name);

/// Does a name end as those of recordings do: sounds, tables, UFF files?
bool has_recording_name(std::string_view name);

/// A recording that is not taken, and why.
struct RefusedRecording {
    std::string file;
    std::string reason;  // a line
};

/// The files behind what a user named.
struct RecordingFiles {
    std::vector<std::filesystem::path> files{};  // in the order named, those of a folder by name
    std::size_t passed_over = 0;                 // [1] in folders, and no recordings by their names
    std::vector<RefusedRecording> unreadable{};  // folders
};

/// Files as they are, and of folders all files below that have a recording's name.
///
/// What is hidden (its name begins with a dot) is not looked at, links to folders are not followed, and the folder
/// `left_out` is left out wherever it is met. The sidecar of a recording beside it is no file of its own.
RecordingFiles recording_files(std::span<const std::string> named, const std::filesystem::path& left_out);

}  // namespace stridor::recordings
