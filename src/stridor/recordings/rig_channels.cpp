#include "stridor/recordings/rig_channels.hpp"

#include "stridor/base/error.hpp"
#include "stridor/signal/source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace stridor::recordings {

namespace {

bool says(const signal::Channel& channel, std::string_view word) {
    std::string name = channel.name;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return name.find(word) != std::string::npos;
}

// of what drives, not of what is driven
bool is_imposed(const signal::Channel& channel) {
    constexpr std::array<std::string_view, 4> words{"surface", "imposed", "drive", "shaker"};
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return says(channel, word); });
}

template <typename Predicate>
std::vector<std::size_t> places_of(const signal::ChannelLayout& layout, Predicate wanted) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (wanted(layout.channels[k])) places.push_back(k);
    return places;
}

// by its name or its number from 1
std::size_t channel_in(const signal::ChannelLayout& layout, const std::string& name, const std::string& unit) {
    const std::size_t found = signal::channel_named(layout, name);
    if (layout.channels[found].unit != unit)
        base::refuse("channel \"" + name + "\" is in " + layout.channels[found].unit, "it must be in " + unit,
                     unit == "N" ? "If it is not calibrated, say --full-scale \"50 N\"." : "");
    return found;
}

}  // namespace

Forces forces_of(const signal::ChannelLayout& layout) {
    Forces forces;
    for (const std::size_t k : places_of(layout, [](const signal::Channel& channel) { return channel.unit == "N"; })) {
        const signal::Channel& channel = layout.channels[k];
        const bool presses = says(channel, "normal") || says(channel, "load");
        (presses ? forces.pressing : forces.rubbing).push_back(k);
    }
    return forces;
}

std::optional<std::size_t> imposed_velocity(const signal::ChannelLayout& layout) {
    const auto is_velocity = [](const signal::Channel& channel) { return channel.unit == "m/s"; };
    const std::vector<std::size_t> velocities = places_of(layout, is_velocity);
    const std::vector<std::size_t> imposed =
        places_of(layout, [&](const signal::Channel& channel) { return is_velocity(channel) && is_imposed(channel); });
    if (!imposed.empty()) return imposed.front();
    if (velocities.size() == 1) return velocities.front();
    return std::nullopt;
}

std::optional<FrictionChannels> friction_channels(const signal::ChannelLayout& layout) {
    const Forces forces = forces_of(layout);
    if (forces.rubbing.size() != 1) return std::nullopt;
    FrictionChannels channels{forces.rubbing.front(), imposed_velocity(layout), std::nullopt};
    if (forces.pressing.size() == 1) channels.normal = forces.pressing.front();
    return channels;
}

FrictionChannels friction_channels(const signal::ChannelLayout& layout, const FrictionChannelNames& named) {
    const Forces forces = forces_of(layout);
    FrictionChannels channels;
    if (!named.force.empty())
        channels.force = channel_in(layout, named.force, "N");
    else if (forces.rubbing.size() == 1)
        channels.force = forces.rubbing.front();
    else
        base::refuse(
            forces.rubbing.empty() ? "no channel is a friction force in newtons"
                                   : "several channels may be the friction force",
            "the file has " + signal::channel_list(layout),
            forces.rubbing.empty() ? "If it is not calibrated, say --full-scale \"50 N\"." : "Name it with --channel.");
    channels.velocity = named.velocity.empty() ? imposed_velocity(layout) : channel_in(layout, named.velocity, "m/s");
    if (!named.normal.empty())
        channels.normal = channel_in(layout, named.normal, "N");
    else if (forces.pressing.size() == 1)
        channels.normal = forces.pressing.front();
    return channels;
}

std::vector<std::size_t> audible_channels(const signal::ChannelLayout& layout) {
    for (const std::string_view unit : {"Pa", "m/s^2", signal::full_scale, "V"}) {
        std::vector<std::size_t> places =
            places_of(layout, [&](const signal::Channel& channel) { return channel.unit == unit; });
        if (!places.empty()) return places;
    }
    const std::vector<std::size_t> velocities =
        places_of(layout, [](const signal::Channel& channel) { return channel.unit == "m/s" && !is_imposed(channel); });
    // beside a friction force a lone velocity is the drive's
    const bool is_drive = velocities.size() == 1 && !forces_of(layout).rubbing.empty();
    if (!velocities.empty() && !is_drive) return velocities;
    const bool is_only = layout.channels.size() == 1 && layout.channels.front().unit != "N";
    return is_only ? std::vector<std::size_t>{0} : std::vector<std::size_t>{};
}

double usual_speed(std::span<const double> velocity) {
    std::vector<double> speed(velocity.begin(), velocity.end());
    for (double& v : speed)
        v = std::abs(v);
    const auto place = static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(speed.size() - 1));
    std::nth_element(speed.begin(), speed.begin() + place, speed.end());
    return speed[static_cast<std::size_t>(place)];
}

PickedChannels::PickedChannels(signal::Source& source, std::vector<std::size_t> places)
    : source_(&source),
      places_(std::move(places)),
      layout_(source.layout()) {
    layout_.channels.clear();
    for (const std::size_t place : places_)
        layout_.channels.push_back(source.layout().channels[place]);
}

std::size_t PickedChannels::read(std::span<double> frames) {
    const std::size_t width = source_->layout().channels.size();
    block_.resize(frames.size() / places_.size() * width);
    const std::size_t count = source_->read(block_);
    for (std::size_t frame = 0; frame < count; ++frame)
        for (std::size_t k = 0; k < places_.size(); ++k)
            frames[frame * places_.size() + k] = block_[frame * width + places_[k]];
    return count;
}

}  // namespace stridor::recordings
