#pragma once

#include "stridor/recordings/raw_signal.hpp"

#include <string>
#include <vector>

namespace stridor::recordings {

/// What keeps a channel from being a signal.
enum class FaultKind { none, no_samples, counter };

/// Why a channel is no signal.
struct ChannelFault {
    FaultKind kind = FaultKind::none;
    std::string why{};  // "is nan in sample 78", "grows by the same step in every sample, as a counter does"
};

/// Reads a source to its end, and tells of each channel why it is no signal, shape [channel].
///
/// Counters are whole numbers, 32 at the least. Throws as the source does.
std::vector<ChannelFault> channel_faults(signal::Source& source);

}  // namespace stridor::recordings
