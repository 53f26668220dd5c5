#pragma once

// Sounds read by ffmpeg's libraries. Private to this folder; only where they were there when Stridor was built.

#include "stridor/recordings/audio/ffmpeg_library.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <string>

namespace stridor::recordings {

/// Opens the first stream of sound; `kind` is what people call the file, `demuxer` ffmpeg's name of its reader.
RawSignal open_with_ffmpeg(const Ffmpeg& ffmpeg, const SignalInput& input, const std::string& kind,
                           const std::string& demuxer);

}  // namespace stridor::recordings
