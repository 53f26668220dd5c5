#pragma once

#include "stridor/recordings/raw_signal.hpp"
#include "stridor/signal/source.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace stridor::recordings {

/// Opens a table of signals: a column per channel, a row per instant.
///
/// `# key: value` lines may come first, or in one line separated by ` | ` as Stridor writes them, or lines of prose;
/// then a row of names, alone, with `name [unit]`, or followed by a row of units. The delimiter is tab, semicolon,
/// comma, or blanks; numbers may have a decimal comma if it is not the delimiter, or in quotes. `assign_roles` decides
/// the meaning of the columns. The times give the rate and must be even; otherwise `# rate: 48000`, `rate` [Hz] or the
/// prose does, and facts that stand twice must agree. A table without names has its time in its first column unless the
/// rate is known. `wanted` is the requested channel: it is not left out quietly. Throws `Error` (input) with line and
/// column if something does not fit.
RawSignal open_signal_csv(const SignalInput& input, std::optional<double> rate = std::nullopt,
                          const std::string& wanted = "");

/// Writes a table of signals: a first line with the schema "stridor.signal/1" and the exact rate, names with units,
/// then a row per frame with its time. Numbers are the shortest that read back as the same doubles. Returns the number
/// of frames.
std::uint64_t write_signal_csv(const std::string& path, signal::Source& source);

}  // namespace stridor::recordings
