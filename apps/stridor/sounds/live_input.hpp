#pragma once

#include "stridor/io/sound/live_events.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/live/byte_flow.hpp"
#include "stridor/recordings/live/stream_form.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stridor::app {

/// Where a live ear listens.
struct LiveInputOptions {
    std::string file = "-";  // standard input
    bool follows = false;    // the file is being written
    bool has_device = false;
    std::string device;    // empty: the usual one
    std::string recorder;  // empty: found
    std::string coding;    // "s24le"; empty: a WAV stream, of a device s16le
    std::string rate = "48000 Hz";
    int channels = 1;
    std::string channel;                   // this one alone
    std::vector<std::string> full_scales;  // "2 Pa"
};

void add_live_input_options(CLI::App& command, LiveInputOptions& options);

/// A piece of a sound that is not over.
struct LivePiece {
    enum class Kind { samples, nothing, lost, end };
    Kind kind = Kind::nothing;
    std::vector<double> frames{};     // [unit] shape [frame][channel]
    std::optional<double> seconds{};  // [s] that are lost
    std::string words{};              // why they are lost, or why it is over
    bool is_cut = false;              // it was to go on
};

/// A sound that is not over, as samples in the channels' units.
class LiveSamples {
public:
    /// Opens the input, and waits for what its head says. Throws `Error`: input for what cannot be heard, io for what
    /// cannot be read, and interrupted if a stop is requested before the head is there.
    LiveSamples(const LiveInputOptions& options, const std::stop_token& stop);

    /// Returns what comes next, within so long.
    LivePiece next(std::chrono::milliseconds longest);

    /// Says whether all of a growing file was heard, and its head promises no more: its writer has closed it.
    bool is_whole() const;

    const io::LiveInput& input() const { return input_; }
    const std::vector<recordings::FullScale>& full_scales() const { return full_scales_; }
    /// Returns how clips are written, so that they hold the samples as they came.
    recordings::WavSamples clip_samples() const;

private:
    void open(const LiveInputOptions& options);
    void read_head(const std::stop_token& stop);
    void describe(const LiveInputOptions& options);
    LivePiece piece_of_pending();
    LivePiece ending(std::string words);
    std::uint64_t bytes_left() const;

    std::unique_ptr<recordings::ByteFlow> flow_{};
    io::LiveInput input_{};
    recordings::StreamForm form_{};
    std::optional<recordings::WavStreamHead> head_{};
    std::vector<recordings::FullScale> full_scales_{};  // of the channels that are heard
    std::vector<std::size_t> picked_{};                 // channels of the stream
    std::string pending_{};                             // bytes that are not heard yet
    std::uint64_t taken_ = 0;                           // [bytes] of samples
    bool is_of_device_ = false;
    bool is_growing_ = false;
    std::string growing_file_{};
};

}  // namespace stridor::app
