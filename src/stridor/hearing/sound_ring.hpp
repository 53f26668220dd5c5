#pragma once

#include "stridor/signal/source.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace stridor::hearing {

/// The last samples of a sound that is not over, in single precision: enough for the whole numbers of 24 bits.
class SoundRing {
public:
    /// Keeps the last `frames` frames of a sound of so many channels.
    SoundRing(std::size_t channels, std::size_t frames);

    /// Takes the next samples, shape [frame][channel].
    void push(std::span<const double> frames);

    /// Returns the number of the first frame that it still has, and of the one that comes next.
    std::uint64_t begin() const;
    std::uint64_t end() const { return end_; }

    /// Returns the frames from one number to another, which it must have, as a source.
    std::unique_ptr<signal::Source> part(const signal::ChannelLayout& layout, std::uint64_t from,
                                         std::uint64_t to) const;

private:
    std::size_t channels_;
    std::size_t frames_;
    std::vector<float> samples_{};  // shape [frame][channel]; it grows to its full size and no further
    std::uint64_t end_ = 0;
};

}  // namespace stridor::hearing
