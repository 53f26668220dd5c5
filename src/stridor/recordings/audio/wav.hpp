#pragma once

#include "stridor/recordings/calibration.hpp"
#include "stridor/signal/source.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stridor::recordings {

/// The longest coding history that other programs still read [bytes].
inline constexpr std::size_t longest_history = 15'000;

/// The line before the case (TOML) of a simulated sound, in the coding history of its file.
inline constexpr const char* case_mark = "# case of stridor\n";

/// How samples are written: whole numbers of 16 or 24 bits, or floating point.
enum class WavSamples { pcm_16, pcm_24, float_32 };

/// How a WAV file is written.
struct WavOptions {
    WavSamples samples = WavSamples::pcm_24;
    std::vector<FullScale> full_scales{};  // the value of 1, for all channels or one each; empty: 1 of its unit
    std::string description{};             // goes into the bext text before the calibration; both fit 256 bytes
    std::string history{};  // how the sound came to be: bext's coding history; at most `longest_history` bytes
};

/// The number of samples written, and of those clipped.
struct WavWritten {
    std::uint64_t frames = 0;
    std::uint64_t clipped = 0;  // [1] samples beyond full scale, cut to it (whole numbers only)
};

/// Writes a WAV file (RF64 beyond 4 GiB) with a calibration in its bext chunk. Writes NAME.wav.json beside it if the
/// WAV cannot hold everything: names, units, full scales, a rate that is not a whole number.
///
/// A sample x becomes x / full scale; in whole numbers the one nearest to that times 2^15 or 2^23, so that samples from
/// such a file go back bit for bit. The same source gives the same bytes. An old sidecar never stands beside a new
/// recording. Throws `Error` (input) for full scales that do not fit the channels in number or unit, and for samples
/// that are not finite.
WavWritten write_wav(const std::string& path, signal::Source& source, const WavOptions& options = {});

/// Returns a short sound as the bytes of a WAV file, 16 bits a sample, with its calibration in the bext chunk. Throws
/// as `write_wav` does.
std::string wav_bytes(const signal::Signal& signal, const FullScale& scale);

}  // namespace stridor::recordings
