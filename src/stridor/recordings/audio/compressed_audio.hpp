#pragma once

#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <memory>
#include <string_view>

namespace stridor::recordings {

/// Does a file begin like a compressed sound that libsndfile does not know: MPEG-4 and its kin
/// (.m4a, .mp4, .mov, .3gp), AAC, AMR, Matroska and WebM?
bool is_compressed_audio(std::string_view beginning);

/// Opens such a sound through ffmpeg's libraries, its first stream of sound; what an encoder adds in front and behind
/// is cut off as the file says.
///
/// The libraries are optional. They get the bytes of this one file, the one demuxer its beginning asks for, and
/// decoders of sound from a short list; they open nothing else. Throws `Error` (input) where they are missing, with
/// what to install, for what is damaged or cut off, and for a sound that is longer than its bytes can hold.
RawSignal open_compressed_audio(const SignalInput& input);

/// Gives an MP3 of uneven bit rate that does not tell its number of frames, or tells fewer than there are, one that
/// does: libsndfile believes it, or guesses it from the first frame's bit rate, and drops what is beyond. The bytes
/// themselves where the number is told or the bit rate is even, or where no frame follows another.
///
/// The number stands in a first frame without sound (Xing, Info, or VBRI); encoders that write into a pipe leave 0.
std::shared_ptr<const Bytes> with_frame_count(std::shared_ptr<const Bytes> bytes);

}  // namespace stridor::recordings
