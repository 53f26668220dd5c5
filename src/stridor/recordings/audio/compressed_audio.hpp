#pragma once

#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <memory>
#include <string_view>

namespace stridor::recordings {

/// Says whether a file begins as a compressed sound that libsndfile does not know: MPEG-4 and its kin (.m4a, .mp4,
/// .mov, .3gp), AAC, AMR, Matroska and WebM.
bool is_compressed_audio(std::string_view beginning);

/// Opens the first stream of such a sound through ffmpeg's libraries. The samples that an encoder adds in front and
/// behind are cut off as the file says.
///
/// The libraries are optional. They get the bytes of this one file, the one demuxer that its beginning needs, and
/// decoders of sound from a short list; they open nothing else. Throws `Error` (input) if they are missing, with the
/// packages to install, for a damaged or truncated file, and for a sound that is longer than its bytes can hold.
RawSignal open_compressed_audio(const SignalInput& input);

/// Returns an MP3 of uneven bit rate with a correct number of frames, if it lacks that number or tells fewer frames
/// than it has. libsndfile believes the number, or guesses it from the first frame's bit rate, and drops the rest.
/// Returns the bytes themselves if the number is right, if the bit rate is even, or if no frame follows another.
///
/// The number stands in a first frame without sound (Xing, Info, or VBRI); encoders that write into a pipe leave 0.
std::shared_ptr<const Bytes> with_frame_count(std::shared_ptr<const Bytes> bytes);

}  // namespace stridor::recordings
