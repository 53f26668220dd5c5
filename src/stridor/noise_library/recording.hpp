#pragma once

#include "stridor/noise_library/library.hpp"

#include <filesystem>
#include <functional>

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
/// Throws `Error`: input for what is no sound, or is there already; io where the file cannot be read, changes meanwhile,
/// or the library has no room.
Entry add_recording(Library& library, const Recording& recording, const Probe& probe);

}  // namespace stridor::noise_library
