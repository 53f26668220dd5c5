#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace stridor::cluster {

/// The clock of a rank and how it waits; tests have a clock of their own.
struct Timing {
    using Clock = std::chrono::steady_clock;

    std::function<Clock::time_point()> now = [] { return Clock::now(); };
    std::function<void(Clock::duration)> pause = [](Clock::duration time) { std::this_thread::sleep_for(time); };
};

/// Between two looks for letters: MPI itself would wait by keeping a processor busy, and a rank that looks a thousand
/// times a second needs less than a hundredth of one.
inline constexpr std::chrono::microseconds busy_pause{1000};

/// Likewise of a rank that has had nothing to do for some time.
inline constexpr std::chrono::microseconds idle_pause{5000};

}  // namespace stridor::cluster
