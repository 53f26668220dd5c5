#pragma once

#include "stridor/signal/source.hpp"

#include <cstddef>
#include <string>
#include <string_view>

/// What users call the channels of a recording.
namespace stridor::signal {

/// The place of a channel, from 0, by its name or its number from 1; a name counts first. Throws `Error` (input) with
/// the channels there are.
std::size_t channel_named(const ChannelLayout& layout, std::string_view name);

/// 1 "force" [N], 2 [Pa]
std::string channel_list(const ChannelLayout& layout);

}  // namespace stridor::signal
