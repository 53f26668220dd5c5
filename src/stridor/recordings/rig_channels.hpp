#pragma once

#include "stridor/signal/source.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The meaning of the channels in a rig's measurement.
namespace stridor::recordings {

/// The places of the channels for a friction trace.
struct FrictionChannels {
    std::size_t force = 0;
    std::optional<std::size_t> velocity{};
    std::optional<std::size_t> normal{};
};

/// The forces by their use: those named "normal", "preload" or "load" press, the others rub.
struct Forces {
    std::vector<std::size_t> rubbing{};
    std::vector<std::size_t> pressing{};
};

/// Returns the channels in N, sorted by their names.
Forces forces_of(const signal::ChannelLayout& layout);

/// Returns the imposed velocity, or `std::nullopt`: the channel named "surface", or the only one in m/s.
std::optional<std::size_t> imposed_velocity(const signal::ChannelLayout& layout);

/// Returns the channels of a file with one friction force, by their own names; `std::nullopt` for any other file.
std::optional<FrictionChannels> friction_channels(const signal::ChannelLayout& layout);

/// A user's names of the channels of a friction trace, or numbers from 1; empty: by the channels' own names.
struct FrictionChannelNames {
    std::string force{};
    std::string velocity{};
    std::string normal{};
};

/// Returns the named channels, else those found by their own names. Throws `Error` (input) if the friction force is not
/// clear, for a channel that does not exist and for one of another unit.
FrictionChannels friction_channels(const signal::ChannelLayout& layout, const FrictionChannelNames& named);

/// Returns the channels that may be heard: sound pressures; without any, accelerations, then uncalibrated channels,
/// then velocities but the imposed one. A force is not a sound.
std::vector<std::size_t> audible_channels(const signal::ChannelLayout& layout);

/// Returns the usual speed [m/s] of a measured velocity: its 95th percentile.
double usual_speed(std::span<const double> velocity);

/// Some channels of a source, in the requested order.
class PickedChannels final : public signal::Source {
public:
    /// Picks channels. The source must outlive this object.
    PickedChannels(signal::Source& source, std::vector<std::size_t> places);

    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> frames) override;

private:
    signal::Source* source_;
    std::vector<std::size_t> places_;
    signal::ChannelLayout layout_;
    std::vector<double> block_{};
};

}  // namespace stridor::recordings
