#pragma once

#include "stridor/recordings/raw_signal.hpp"
#include "stridor/signal/source.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stridor::recordings {

/// Says whether this is the beginning of a Universal File.
bool is_uff(std::string_view beginning);

/// Opens the time histories of a Universal File: datasets 58 (ASCII) and 58b (binary) of function type 1.
///
/// Other datasets are skipped. Time histories of the same rate and length are channels; otherwise `dataset`, counted
/// from 1 among the time histories, chooses one. The rate is taken from an ID line "rate: 48000 Hz" if it agrees with
/// the step; else the step is snapped to an exact rate within the uncertainty of its digits. Throws `Error` (input)
/// with the line for an uneven step, complex values and a truncated file. If the header states another number of values
/// than there are, the existing ones are read, with a note.
RawSignal open_uff58(const SignalInput& input, std::optional<std::size_t> dataset = std::nullopt);

/// The form of the numbers.
enum class Uff58Form { ascii, binary };

/// Writes the channels as datasets 58 (ASCII, 13 digits) or 58b (binary, little endian, the exact doubles).
///
/// The name of a channel stands in ID line 1 and as the label of its axis, the exact rate in ID line 4. The text goes
/// through a temporary file first: its headers need the number of values. Returns the number of frames.
std::uint64_t write_uff58(const std::string& path, signal::Source& source, Uff58Form form);

}  // namespace stridor::recordings
