#pragma once

#include "stridor/signal/source.hpp"

#include <string>

namespace stridor::app {

/// What a sound file says of itself.
struct SoundFileInfo {
    double full_scale = 1.0;  // [unit of the sound] what the largest magnitude of the file stands for
    std::string description;  // free text; the calibration is put in front of it
};

/// Writes one channel as a WAV file of 24 bit with its calibration in the bext chunk ("full scale = 0.5 m/s").
///
/// The file has its name only once it is whole. Throws `Error` (io), and `Error` (input) for a sound beyond 4 GB.
void write_sound(const std::string& path, signal::Source& sound, const SoundFileInfo& info);

}  // namespace stridor::app
