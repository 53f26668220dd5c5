#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace stridor::cluster {

/// A message that has arrived.
struct Letter {
    int from = 0;  // [1] the rank that sent it
    std::string bytes;
};

/// Carries messages between the ranks of a job: processes that are numbered from 0 on.
///
/// Letters from one rank to another arrive in the order in which they were sent; those of different ranks in any order.
/// Only one thread of a rank, always the same, may use its post. Neither call waits.
class Post {
public:
    Post() = default;
    virtual ~Post() = default;
    Post(const Post&) = delete;
    Post& operator=(const Post&) = delete;

    /// Returns the number of this rank, from 0 to `ranks() - 1`.
    virtual int rank() const = 0;
    /// Returns the number of ranks.
    virtual int ranks() const = 0;

    /// Sends to another rank, and returns before it has arrived.
    virtual void send(int to, std::string bytes) = 0;

    /// Returns the next letter that has arrived, or `std::nullopt` if there is none.
    virtual std::optional<Letter> poll() = 0;
};

/// The clock of a rank and how it waits; tests have a clock of their own.
struct Timing {
    using Clock = std::chrono::steady_clock;

    std::function<Clock::time_point()> now = [] { return Clock::now(); };
    std::function<void(Clock::duration)> pause = [](Clock::duration time) { std::this_thread::sleep_for(time); };
};

/// The pause between two looks for letters. MPI itself would keep a processor busy while it waits; a rank that looks a
/// thousand times a second needs less than a hundredth of one.
inline constexpr std::chrono::microseconds busy_pause{1000};

/// The pause between two looks of a rank that has had nothing to do for some time.
inline constexpr std::chrono::microseconds idle_pause{5000};

}  // namespace stridor::cluster
