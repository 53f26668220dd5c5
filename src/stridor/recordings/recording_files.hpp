#pragma once

#include "stridor/base/error.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// Says whether a name ends as a sound file's does: ".wav", ".flac", in either case of its letters.
bool has_sound_name(std::string_view name);

/// Says whether a name ends as a recording's does: a sound, a table, a UFF file.
bool has_recording_name(std::string_view name);

/// A recording that is refused, and the reason.
struct RefusedRecording {
    std::string file;
    std::string reason;  // a line
};

/// Returns the reason for which a file is refused, as a line that names the file: "run.csv:12: the file is empty".
std::string refusal_reason(const std::string& file, const base::Error& error);

/// The files that a user's names stand for.
struct RecordingFiles {
    std::vector<std::filesystem::path> files{};  // in the order named, those of a folder by name
    std::size_t passed_over = 0;                 // [1] in folders, and no recordings by their names
    std::vector<RefusedRecording> unreadable{};  // folders
};

/// Returns files as they are, and for folders all files below with a recording's name.
///
/// Hidden files (whose names begin with a dot) are ignored, links to folders are not followed, and the folder
/// `left_out` is left out everywhere. The sidecar beside a recording does not count as a file.
RecordingFiles recording_files(std::span<const std::string> named, const std::filesystem::path& left_out);

}  // namespace stridor::recordings
