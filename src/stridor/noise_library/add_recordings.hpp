#pragma once

#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/recording_files.hpp"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::noise_library {

/// Writes Stridor's results on a sound file into an entry: duration, rate, channels, calibration if it is not given,
/// verdict and figures. Throws `Error` (input) for a file that is not a sound.
using Probe = std::function<void(const std::filesystem::path& file, Entry& entry)>;

/// A recording to add, and the facts known of it.
struct Recording {
    std::filesystem::path file;
    Entry given;
    Twins twins = Twins::refuse_same_audio;
};

/// Adds a recording and returns its entry as the library holds it.
///
/// Throws `Error`: input for a file that is not a sound, is there already, or changes meanwhile; io if the file cannot
/// be read or the library has no room. Throws the probe's errors, too.
Entry add_recording(Library& library, const Recording& recording, const Probe& probe);

/// Returns the library's name of a file's sound: the SHA-256 of its bytes. Throws `Error`: input for a path that is not
/// a file, io if it cannot be read.
std::string audio_hash(const std::filesystem::path& file);

/// A recording that the library already has.
struct KnownRecording {
    std::string file;
    std::int64_t id = 0;  // of the entry that has its sound
};

/// The results of adding many recordings, one after the other.
struct Arrivals {
    std::vector<std::int64_t> added{};                    // ids, in the order of the files
    std::vector<KnownRecording> known{};                  // skipped
    std::vector<recordings::RefusedRecording> refused{};  // skipped
    std::size_t passed_over = 0;                          // [1] files whose names are not those of recordings
    std::size_t left = 0;                                 // [1] files that were not reached before a stop
};

/// What happens to a recording whose sound an entry already has.
enum class Known { skipped, added_again };

/// What happens to a broken recording: it is listed in `Arrivals`, or its error ends all.
enum class Refused { listed, thrown };

/// How recordings are added.
struct Adding {
    Entry given{};  // facts of all of them
    Known known = Known::skipped;
    Refused refused = Refused::listed;
    Probe probe{};
    std::stop_token stop{};
    std::function<void(const std::filesystem::path& file)> begin{};  // of a file
    std::function<void(const Entry& entry)> added{};                 // as the library has it
    std::function<void()> end{};                                     // of a file
};

/// The results, also if an error ended the adding.
struct Added {
    Arrivals arrivals{};
    std::exception_ptr ended_by{};  // null if there was no error
};

/// Adds one file after the other; known and broken ones are skipped.
///
/// It ends early at a stop (`Error`, interrupted) and at an error of the library. After all files, a refused one throws
/// `Error` (input). All added entries stay.
Added add_recordings(Library& library, const recordings::RecordingFiles& files, const Adding& adding);

/// Throws `Error` (interrupted) if a stop is requested, with `left` files left: for a probe that takes long.
void go_on(const std::stop_token& stop, std::size_t left);

}  // namespace stridor::noise_library
