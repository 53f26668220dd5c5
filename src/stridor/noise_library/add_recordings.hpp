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

/// Fills what Stridor knows of a sound file into an entry: duration, rate, channels, calibration where it is not given,
/// verdict and figures. Throws `Error` (input) for what is no sound.
using Probe = std::function<void(const std::filesystem::path& file, Entry& entry)>;

/// What is added, and what is known of it.
struct Recording {
    std::filesystem::path file;
    Entry given;
    Twins twins = Twins::refuse_same_audio;
};

/// Adds a recording and gives its entry as the library has it.
///
/// Throws `Error`: input for what is no sound, is there already, or changes meanwhile; io where the file cannot be read
/// or the library has no room; and what the probe throws.
Entry add_recording(Library& library, const Recording& recording, const Probe& probe);

/// What a library calls the sound of this file: the SHA-256 of its bytes. Throws `Error`: input for what is no file, io
/// where it cannot be read.
std::string audio_hash(const std::filesystem::path& file);

/// A recording that is in the library already.
struct KnownRecording {
    std::string file;
    std::int64_t id = 0;  // of the entry that has its sound
};

/// What became of many recordings that were added one after the other.
struct Arrivals {
    std::vector<std::int64_t> added{};                    // ids, in the order of the files
    std::vector<KnownRecording> known{};                  // skipped
    std::vector<recordings::RefusedRecording> refused{};  // skipped
    std::size_t passed_over = 0;                          // [1] files that are no recordings by their names
    std::size_t left = 0;  // [1] files that were not looked at before a stop was asked for
};

/// What becomes of a recording whose sound an entry has already.
enum class Known { skipped, added_again };

/// What becomes of a recording that is broken: it stands in `Arrivals`, or its error ends all.
enum class Refused { listed, thrown };

/// How recordings are added.
struct Adding {
    Entry given{};  // what is said of all
    Known known = Known::skipped;
    Refused refused = Refused::listed;
    Probe probe{};
    std::stop_token stop{};
    std::function<void(const std::filesystem::path& file)> begin{};  // of a file
    std::function<void(const Entry& entry)> added{};                 // as the library has it
    std::function<void()> end{};                                     // of a file
};

/// What became of them, also where an error ended it.
struct Added {
    Arrivals arrivals{};
    std::exception_ptr ended_by{};  // nothing if all is well
};

/// Adds one file after the other, past what is known and what is broken.
///
/// What ends it: a stop (`Error`, interrupted), an error of the library, and, after all are tried, a file that was
/// refused (`Error`, input). What is added by then stays.
Added add_recordings(Library& library, const recordings::RecordingFiles& files, const Adding& adding);

/// Throws `Error` (interrupted) if a stop is asked for with so many files left: for a probe that takes long.
void go_on(const std::stop_token& stop, std::size_t left);

}  // namespace stridor::noise_library
