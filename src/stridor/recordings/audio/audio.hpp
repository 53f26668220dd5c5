#pragma once

#include "stridor/recordings/raw_signal.hpp"

#include <string_view>

namespace stridor::recordings {

/// Says whether a file begins as a sound file that `open_audio` reads: WAV (RIFF, RF64, W64), FLAC, Ogg, AIFF, CAF, AU,
/// MP3.
bool is_audio(std::string_view beginning);

/// Opens a sound file through libsndfile. Whole numbers are divided by the largest magnitude they can have.
///
/// The file's claims are checked against its size. Throws `Error` (input) for damaged and truncated files, for files
/// without samples, and for rates outside 1 Hz ... 100 MHz.
RawSignal open_audio(const SignalInput& input);

}  // namespace stridor::recordings
