#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

/// Bounded waits for another process.
namespace stridor::storage {

/// How a wait is ended, and who is told about it.
struct WaitOptions {
    std::stop_token stop{};                                // ends it
    std::function<void(const std::string& words)> note{};  // after a second: who is waited for, how long at most
};

/// One wait: it has a bound, says after a second what it waits for, and ends on request.
class Waiting {
public:
    /// Begins a wait of at most `longest`.
    Waiting(WaitOptions options, std::chrono::milliseconds longest) : options_(std::move(options)), longest_(longest) {}

    /// Waits a moment, from a hundredth of a second on ever longer; returns false once the bound is reached. `whom` is
    /// told after a second: "process 17 of host n2, which takes over the store". Throws `Error` (interrupted) on
    /// request.
    bool goes_on(const std::string& whom);

private:
    using Clock = std::chrono::steady_clock;

    WaitOptions options_;
    std::chrono::milliseconds longest_;
    std::chrono::milliseconds moment_{10};
    Clock::time_point begun_ = Clock::now();
    bool has_told_ = false;
};

/// Measures, by the clock of this machine, for how long something stays unchanged.
class Unchanged {
public:
    /// Returns for how long the watched thing has been in this state, or `std::nullopt` if it changed since the last
    /// look.
    std::optional<std::chrono::steady_clock::duration> look(const std::string& state);

private:
    std::string state_{};  // empty: not looked at yet
    std::chrono::steady_clock::time_point since_{};
};

}  // namespace stridor::storage
