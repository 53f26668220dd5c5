#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stridor::support {

/// Random numbers out of a counter (SplitMix64, Steele, Lea, Flood 2014): run k is the same whatever ran before it.
class CounterRandom {
public:
    // a run's numbers start far from those of its neighbour: a hash of its number, not the number
    explicit CounterRandom(std::uint64_t run) : state_(run) { state_ = next() ^ (next() << 1U); }

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }
    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : next() % bound; }

    /// Evenly spread in [low, high).
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1p-53);
    }

    /// Its logarithm evenly spread.
    double decades(double low, double high) { return std::pow(10.0, between(std::log10(low), std::log10(high))); }

    bool one_in(std::size_t count) { return below(count) == 0; }

private:
    std::uint64_t state_;
};

}  // namespace stridor::support
