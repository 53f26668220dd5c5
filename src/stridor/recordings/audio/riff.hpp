#pragma once

#include "stridor/recordings/bytes.hpp"

#include <cstdint>
#include <optional>

namespace stridor::recordings {

/// The samples of a WAV file as its header has them.
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

    /// A writer that could not go back (a pipe) leaves 0 or the largest number: as long as the file is.
    bool has_unknown_length() const;

    /// Do the sizes of samples and frames agree? Packed codings have rules of their own.
    bool has_sensible_frames() const;
};

/// Walks the chunks of a RIFF or RF64 file up to its samples; nothing where there are none.
std::optional<RiffData> find_riff_data(const Bytes& bytes);

}  // namespace stridor::recordings
