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

/// The unit of samples that nobody has calibrated: 1 is the largest magnitude their file can hold.
inline constexpr const char* full_scale = "FS";

/// One channel of sampled data, uniform in time: a recorded sound, a measured force, a simulated velocity.
struct Signal {
    double rate = 0.0;              // [Hz] samples per second
    std::string unit = full_scale;  // of the samples: "Pa", "m/s^2", "m/s", "N", or "FS"
    std::vector<double> samples{};  // [unit] shape [frame]
};

/// The time a signal lasts [s].
inline double duration(const Signal& signal) {
    return static_cast<double>(signal.samples.size()) / signal.rate;
}

/// One channel of a recording.
struct Channel {
    std::string name;               // "left", "friction force"; may be empty
    std::string unit = full_scale;  // of its samples
};

/// What is known of a recording before its first sample.
struct ChannelLayout {
    double rate = 0.0;  // [Hz] frames per second
    std::vector<Channel> channels{};
    std::optional<std::uint64_t> frames{};  // samples per channel; nothing where the file does not say
};

/// The largest size of a sample, in whatever unit. No instrument shows more, and the fourth powers of as many samples
/// as fit a disk add up to a number. Beyond it levels are infinite, and nothing that rests on them has a value.
inline constexpr double largest_sample = 1e30;

/// Is this a sample to compute with: a number, and none too large?
constexpr bool is_sample(double value) {
    return -largest_sample <= value && value <= largest_sample;
}

/// What is wrong with a value that is no sample; `number` counts the samples of its channel from 1.
base::Problem sample_problem(double value, const Channel& channel, std::uint64_t number);

/// A recording that is read in blocks, once, from its first frame to its last: hours of it never stand in memory.
class Source {
public:
    virtual ~Source() = default;

    /// Rate and channels.
    virtual const ChannelLayout& layout() const = 0;

    /// Fills `frames` with the next samples in the channels' units, shape [frame][channel], and returns how many frames
    /// it could fill: fewer than fit only at the end, where it returns 0.
    ///
    /// The span holds a whole number of frames. Throws `Error` (input) for a damaged file and `Error` (io) where
    /// reading fails.
    virtual std::size_t read(std::span<double> frames) = 0;
};

/// The channels of a source, each as a signal of its own; the source is at its end afterwards.
///
/// Throws `Error` (input) if it holds more than `limit` samples altogether: what is long is read in blocks.
std::vector<Signal> read_all(Source& source, std::uint64_t limit = std::uint64_t{1} << 28U);

/// Signals of one rate and length as a source.
std::unique_ptr<Source> source_of(std::vector<Signal> channels);

// What users call the channels of a recording.

/// The place of a channel, from 0, by its name or its number from 1; a name counts first. Throws `Error` (input) with
/// the channels there are.
std::size_t channel_named(const ChannelLayout& layout, std::string_view name);

/// 1 "force" [N], 2 [Pa]
std::string channel_list(const ChannelLayout& layout);

}  // namespace stridor::signal
