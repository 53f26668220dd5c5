#pragma once

#include "stridor/recordings/raw_signal.hpp"

#include <optional>
#include <string>

namespace stridor::recordings {

/// Opens a table of signals: a column per channel, a row per instant.
///
/// `# key: value` lines may come first, or in one line parted by ` | ` as Stridor writes them, or lines of prose; then
/// a row of names, alone, with `name [unit]`, or followed by a row of units. The delimiter is tab, semicolon or comma;
/// with the first two, or with a single column, numbers may have a decimal comma. A column named time or t, or in a
/// unit of time, gives the rate and must be even; otherwise `# rate: 48000`, `rate` [Hz] or the prose does. Columns of
/// words are left out. A table without names has its time in its first column unless the rate is known.
/// Throws `Error` (input) with line and column for whatever does not fit.
RawSignal open_signal_csv(const SignalInput& input, std::optional<double> rate = std::nullopt);

}  // namespace stridor::recordings
