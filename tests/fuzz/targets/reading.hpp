#pragma once

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::fuzz {

/// Opens bytes as a recording and reads it to its end; `open` takes the input. A byte holds
/// `most_per_byte` frames at most.
template <typename Open>
void read_signal(std::string_view bytes, Open open, std::uint64_t most_per_byte = 1) {
    try {
        const recordings::RawSignal raw =
            open(recordings::SignalInput{recordings::bytes_of(std::string(bytes)), "input", {}});
        const signal::ChannelLayout& layout = raw.source->layout();
        const std::size_t width = layout.channels.size();
        require(width > 0 && layout.rate > 0.0 && std::isfinite(layout.rate));
        std::vector<double> block(16 * width);
        std::uint64_t frames = 0;
        while (const std::size_t count = raw.source->read(block)) {
            require(count <= 16);
            frames += count;
            require(frames / most_per_byte <= bytes.size());
        }
        require(!layout.frames || *layout.frames == frames);
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && error.place().has_value() && !error.problem().what.empty());
    }
}

}  // namespace stridor::fuzz
