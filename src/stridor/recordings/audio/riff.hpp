#pragma once

#include "stridor/recordings/bytes.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stridor::recordings {

/// The place and form of the samples of a WAV file, as its header states them.
struct RiffData {
    std::uint64_t offset = 0;     // [bytes] of the first sample
    std::uint64_t claimed = 0;    // [bytes] that the header gives them
    std::uint64_t available = 0;  // [bytes] that the file holds from there on
    std::uint32_t rate = 0;       // [Hz]
    std::uint16_t channels = 0;
    std::uint16_t coding = 0;       // 1: whole numbers, 3: floats, others: packed
    std::uint16_t bits = 0;         // [1] of one sample
    std::uint16_t frame_bytes = 0;  // [bytes] of one sample of all channels
    bool has_format = false;        // a fmt chunk stands before the samples
    std::string kept{};             // its fmt and bext chunks, byte by byte

    /// Says whether the header leaves the length open. A writer that could not go back (a pipe) leaves 0 or the largest
    /// number: the samples then reach to the end of the file.
    bool has_unknown_length() const;

    /// Says whether 24 bits stand in 4 bytes, as some recorders write them; libraries read such samples as noise.
    bool has_wide_frames() const;

    /// Says whether the sizes of samples and frames agree. Packed codings have rules of their own.
    bool has_sensible_frames() const;
};

/// Says whether this is the mark of a WAV file: RIFF, RF64 (EBU 3306) or BW64 (ITU-R BS.2088).
bool is_riff_mark(std::string_view mark);

/// Walks the chunks of a RIFF, RF64 or BW64 file up to its samples; returns `std::nullopt` if there are none.
std::optional<RiffData> find_riff_data(const Bytes& bytes);

/// Makes a plain WAV file of a recording's format, description and existing samples, for a header that no library
/// accepts although the place of the samples is clear.
std::shared_ptr<const Bytes> plain_wav(std::shared_ptr<const Bytes> bytes, const RiffData& data);

/// Returns the bytes from a place on, behind another head.
std::shared_ptr<const Bytes> with_head(std::string head, std::shared_ptr<const Bytes> bytes, std::uint64_t from);

}  // namespace stridor::recordings
