#pragma once

#include "stridor/recordings/bytes.hpp"

#include <memory>

namespace stridor::recordings {

/// Gives an MP3 of uneven bit rate that does not tell its number of frames, or tells fewer than there are, one that
/// does: libsndfile believes it, or guesses it from the first frame's bit rate, and drops what is beyond. The bytes
/// themselves where the number is told or the bit rate is even, or where no frame follows another.
///
/// The number stands in a first frame without sound (Xing, Info, or VBRI); encoders that write into a pipe leave 0.
std::shared_ptr<const Bytes> with_frame_count(std::shared_ptr<const Bytes> bytes);

}  // namespace stridor::recordings
