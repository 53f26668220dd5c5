#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

/// Waiting in tests: for a condition, never for a time.
namespace stridor::support {

/// Waits until `holds()`; false if it has not come to hold within the limit, which is far more than it takes.
///
/// Asks every millisecond, for what other processes do tells nobody. It is the one place in the tests that sleeps.
template <typename Condition>
bool wait_until(Condition holds, std::chrono::milliseconds limit = std::chrono::minutes(2)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// Waits until a stop is requested; false if none was within the limit.
inline bool wait_for_stop(const std::stop_token& stop, std::chrono::milliseconds limit = std::chrono::minutes(2)) {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    stopped.wait_for(lock, stop, limit, [] { return false; });
    return stop.stop_requested();
}

}  // namespace stridor::support
