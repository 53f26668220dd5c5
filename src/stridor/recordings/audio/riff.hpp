#pragma once

#include "stridor/recordings/bytes.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

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
    std::string kept{};             // its fmt and bext chunks, byte by byte

    /// A writer that could not go back (a pipe) leaves 0 or the largest number: as long as the file is.
    bool has_unknown_length() const;

    /// 24 bits in 4 bytes, as some recorders write it, which libraries read as noise.
    bool has_wide_frames() const;

    /// Do the sizes of samples and frames agree? Packed codings have rules of their own.
    bool has_sensible_frames() const;
};

/// Is this the mark of a WAV file: RIFF, RF64 (EBU 3306) or BW64 (ITU-R BS.2088)?
bool is_riff_mark(std::string_view mark);

/// Walks the chunks of a RIFF, RF64 or BW64 file up to its samples; `std::nullopt` where there are none.
std::optional<RiffData> find_riff_data(const Bytes& bytes);

/// Makes a plain WAV file of a recording's format, description and all samples that are there: for a header that no
/// library takes though it is clear where the samples are.
std::shared_ptr<const Bytes> plain_wav(std::shared_ptr<const Bytes> bytes, const RiffData& data);

/// Bytes from a place on, behind a head of their own.
std::shared_ptr<const Bytes> with_head(std::string head, std::shared_ptr<const Bytes> bytes, std::uint64_t from);

}  // namespace stridor::recordings
