#pragma once

#include "stridor/recordings/calibration.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// How one sample stands in the bytes of a stream, in little-endian order.
enum class SampleCoding { u8, s16, s24, s32, f32, f64 };

/// Returns the words for them: "s16le".
std::vector<std::string> sample_coding_names();

/// Returns the coding of a word. Throws `Error` (input) that lists the words.
SampleCoding sample_coding_of(std::string_view name);

/// Returns the bytes of one sample.
std::size_t bytes_of(SampleCoding coding);

/// How the samples of a stream stand in its bytes: frame after frame.
struct StreamForm {
    SampleCoding coding = SampleCoding::s16;
    double rate = 0.0;         // [Hz]
    std::size_t channels = 0;  // [1]

    /// Returns the bytes of one sample of all channels.
    std::size_t frame_bytes() const { return channels * bytes_of(coding); }
    bool operator==(const StreamForm&) const = default;
};

/// Returns "24 bit, 48000 Hz, 4 channels".
std::string stream_form_text(const StreamForm& form);

/// Reads whole frames; whole numbers are divided by the largest magnitude they can have, as `open_audio` does. `bytes`
/// and `samples` hold the same number of frames.
void decode(const StreamForm& form, std::span<const char> bytes, std::span<double> samples);

/// The head of a WAV stream: what stands before the samples.
struct WavStreamHead {
    StreamForm form{};
    std::size_t bytes = 0;                    // [bytes] before the first sample
    std::optional<std::uint64_t> promised{};  // [bytes] of samples; nothing: the head leaves the length open
    std::string description{};                // bext text, which may hold a calibration
};

/// Says whether the first bytes of a stream, at least four, are those of a WAV file.
bool is_wav_stream(std::string_view bytes);

/// Returns the head of a WAV stream from its first bytes; `std::nullopt` if there are too few of them.
///
/// A writer that cannot go back leaves the length open: 0, 0xFFFFFFFF, or what sox and ffmpeg write. Throws `Error`
/// (input) for samples that are packed, for a head without a format or of more than 1 MiB. `name` is for messages.
std::optional<WavStreamHead> wav_stream_head(std::string_view bytes, const std::string& name);

}  // namespace stridor::recordings
