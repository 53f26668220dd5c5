#pragma once

#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/signal/source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What a recording holds, after all of it was read.
struct SignalSummary {
    recordings::SignalFacts facts;
    signal::ChannelLayout layout;  // its `frames` are those that were read
    std::vector<double> peaks{};   // [unit] largest magnitude, shape [channel]
};

/// A file that a recording was written to.
struct SignalOutput {
    std::string name;
    std::string format;         // "wav", "csv", "uff58", "uff58b"
    std::uint64_t clipped = 0;  // [1] samples cut to full scale
};

/// A source that passes another one on and keeps what it saw.
class WatchedSource final : public signal::Source {
public:
    /// The source must outlive this.
    explicit WatchedSource(signal::Source& source);

    const signal::ChannelLayout& layout() const override { return source_.layout(); }
    std::size_t read(std::span<double> frames) override;

    /// Frames that were read so far [1].
    std::uint64_t frames() const { return frames_; }
    /// Returns largest magnitude of each channel so far.
    const std::vector<double>& peaks() const { return peaks_; }  // [unit] shape [channel]

private:
    signal::Source& source_;
    std::uint64_t frames_ = 0;
    std::vector<double> peaks_;
};

/// Reads a recording to its end. Throws what reading throws.
SignalSummary summary_of(recordings::SignalFile& file);

/// Returns "option", "sidecar", "description", "file" or "none".
std::string_view name(recordings::Calibration calibration);

/// Returns "stridor.convert/1": the recording (rate, frames, duration, channels, notes, metadata) and,
/// if it was written, the output.
std::string convert_json(const SignalSummary& summary, const std::optional<SignalOutput>& output);

// A recording written in another format.

/// What a recording is to be written to, as a command line says it.
struct SignalTarget {
    std::string file;      // "-": standard output
    std::string format{};  // "wav", "csv", "uff58", "uff58b"; empty: by the file's name
    std::string bits{};    // of a WAV's samples: "16", "24", "float"; empty: as they came, or float
};

/// Returns the format by the target's own word or the ending of its name. Throws `Error` (input) for an unknown ending.
std::string format_of(const SignalTarget& target);

/// Returns the next of 1, 2, 5, 10, ... above a peak, so that whole numbers end one step below full scale; 1 for
/// silence.
double round_full_scale(double peak);

/// Writes a recording. A sound keeps its own full scale; other measurements get one they fit in.
///
/// Throws `Error` (input) for a WAV to standard output, whose header needs the length, and what writing throws.
SignalOutput write_signal(const SignalTarget& target, const SignalSummary& summary, signal::Source& source);

}  // namespace stridor::io
