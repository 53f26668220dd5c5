#pragma once

#include "stridor/signal/source.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What the channels of a rig's measurement are.
namespace stridor::recordings {

/// Places of the channels that a friction trace is made of.
struct FrictionChannels {
    std::size_t force = 0;
    std::optional<std::size_t> velocity{};
    std::optional<std::size_t> normal{};
};

/// Forces by what they do: those that say "normal", "preload" or "load" press, the others rub.
struct Forces {
    std::vector<std::size_t> rubbing{};
    std::vector<std::size_t> pressing{};
};

/// The channels in N, by their names.
Forces forces_of(const signal::ChannelLayout& layout);

/// The imposed velocity: the channel that says "surface", or the only one in m/s.
std::optional<std::size_t> imposed_velocity(const signal::ChannelLayout& layout);

/// The channels of a file that has one friction force, as they say themselves; nothing for any other.
std::optional<FrictionChannels> friction_channels(const signal::ChannelLayout& layout);

/// What a user calls the channels of a friction trace: names or numbers from 1; empty: as the channels say themselves.
struct FrictionChannelNames {
    std::string force{};
    std::string velocity{};
    std::string normal{};
};

/// The channels that are named, else what they say themselves. Throws `Error` (input) where the friction force is not
/// clear, for a channel that is not there and for one of another unit.
FrictionChannels friction_channels(const signal::ChannelLayout& layout, const FrictionChannelNames& named);

/// The channels that may be heard: sound pressures; without any accelerations, then what is not calibrated, then
/// velocities but the imposed one. A force is no sound.
std::vector<std::size_t> audible_channels(const signal::ChannelLayout& layout);

/// The usual speed [m/s] of a measured velocity: its 95th percentile.
double usual_speed(std::span<const double> velocity);

/// Some channels of a source, in the order wanted.
class PickedChannels final : public signal::Source {
public:
    /// The source must outlive it.
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
