#pragma once

#include "stridor/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// The unit of uncalibrated samples: 1 is the largest magnitude that their file can hold.
inline constexpr const char* full_scale = "FS";

/// One channel of sampled data, uniform in time: a recorded sound, a measured force, a simulated velocity.
struct Signal {
    double rate = 0.0;              // [Hz] samples per second
    std::string unit = full_scale;  // of the samples: "Pa", "m/s^2", "m/s", "N", or "FS"
    std::vector<double> samples{};  // [unit] shape [frame]
};

/// Returns the duration of a signal [s].
inline double duration(const Signal& signal) {
    return static_cast<double>(signal.samples.size()) / signal.rate;
}

/// One channel of a recording.
struct Channel {
    std::string name;               // "left", "friction force"; may be empty
    std::string unit = full_scale;  // of its samples
};

/// The properties of a recording that are known before its first sample.
struct ChannelLayout {
    double rate = 0.0;  // [Hz] frames per second
    std::vector<Channel> channels{};
    std::optional<std::uint64_t> frames{};  // samples per channel; `std::nullopt` if the file does not say
};

/// The largest magnitude of a sample in any unit. No instrument shows more, and the sum of the fourth powers of a whole
/// disk of such samples is still finite. Beyond it levels are infinite, and results from them have no value.
inline constexpr double largest_sample = 1e30;

/// Says whether a value can be computed with: it is a number and not too large.
constexpr bool is_sample(double value) {
    return -largest_sample <= value && value <= largest_sample;
}

/// Returns the problem of a value that is not a sample. `number` counts the samples of its channel from 1.
base::Problem sample_problem(double value, const Channel& channel, std::uint64_t number);

/// A recording that is read in blocks, once, from its first frame to its last: hours of it never stand in memory.
class Source {
public:
    virtual ~Source() = default;

    /// Returns rate and channels.
    virtual const ChannelLayout& layout() const = 0;

    /// Fills `frames` with the next samples in the channels' units, shape [frame][channel], and returns the number of
    /// frames that it filled: fewer than fit only at the end, then 0.
    ///
    /// The span holds a whole number of frames. Throws `Error` (input) for a damaged file and `Error` (io) if reading
    /// fails.
    virtual std::size_t read(std::span<double> frames) = 0;
};

/// Returns the channels of a source, each as a signal of its own. The source is at its end afterwards.
///
/// Throws `Error` (input) if it holds more than `limit` samples altogether: a long recording is read in blocks.
std::vector<Signal> read_all(Source& source, std::uint64_t limit = std::uint64_t{1} << 28U);

/// Returns signals of one rate and length as a source.
std::unique_ptr<Source> source_of(std::vector<Signal> channels);

// What users call the channels of a recording.

/// Returns the place of a channel, from 0, by its name or its number from 1; a name counts first. Throws `Error`
/// (input) that lists the channels if there is no such channel.
std::size_t channel_named(const ChannelLayout& layout, std::string_view name);

/// Returns the channels in words: 1 "force" [N], 2 [Pa]
std::string channel_list(const ChannelLayout& layout);

}  // namespace stridor::signal
