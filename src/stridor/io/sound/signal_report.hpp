#pragma once

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
    /// Largest magnitude of each channel so far.
    const std::vector<double>& peaks() const { return peaks_; }  // [unit] shape [channel]

private:
    signal::Source& source_;
    std::uint64_t frames_ = 0;
    std::vector<double> peaks_;
};

/// Reads a recording to its end. Throws what reading throws.
SignalSummary summary_of(recordings::SignalFile& file);

/// "option", "sidecar", "description", "file" or "none".
std::string_view name(recordings::Calibration calibration);

/// "stridor.convert/1": the recording (rate, frames, duration, channels, notes, metadata) and,
/// if it was written, the output.
std::string convert_json(const SignalSummary& summary, const std::optional<SignalOutput>& output);

}  // namespace stridor::io
