#pragma once

#include "stridor/io/sound/signal_report.hpp"
#include "stridor/recordings/audio/wav.hpp"

#include <string>

/// A recording written in another format.
namespace stridor::io {

/// What a recording is to be written to, as a command line says it.
struct SignalTarget {
    std::string file;      // "-": standard output
    std::string format{};  // "wav", "csv", "uff58", "uff58b"; empty: by the file's name
    std::string bits{};    // of a WAV's samples: "16", "24", "float"; empty: as they came, or float
};

/// The format by the target's own word or the ending of its name. Throws `Error` (input) for an unknown ending.
std::string format_of(const SignalTarget& target);

/// The next of 1, 2, 5, 10, ... above a peak, so that whole numbers end one step below full scale; 1 for silence.
double round_full_scale(double peak);

/// Writes a recording. A sound keeps its own full scale; other measurements get one they fit in.
///
/// Throws `Error` (input) for a WAV to standard output, whose header needs the length, and what writing throws.
SignalOutput write_signal(const SignalTarget& target, const SignalSummary& summary, signal::Source& source);

}  // namespace stridor::io
