#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace stridor::support {

/// Somebody who waits so long [s] for a run and then presses Ctrl-C; and how long the run took to end after that.
class Patience {
public:
    using Clock = std::chrono::steady_clock;

    explicit Patience(double seconds)
        : begin_(Clock::now()),
          waiting_([this, seconds](const std::stop_token& leave) {
              std::unique_lock lock(mutex_);
              const auto end =
                  begin_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
              if (over_.wait_until(lock, leave, end, [&] { return leave.stop_requested(); })) return;
              pressed_ = Clock::now();
              has_pressed_ = true;
              stop_.request_stop();
          }) {}

    std::stop_token token() const { return stop_.get_token(); }

    /// [s] from Ctrl-C until now; 0 if it was not needed.
    double kept_waiting() {
        const std::lock_guard lock(mutex_);
        return has_pressed_ ? std::chrono::duration<double>(Clock::now() - pressed_).count() : 0.0;
    }

private:
    Clock::time_point begin_;
    Clock::time_point pressed_{};
    bool has_pressed_ = false;
    std::stop_source stop_;
    std::mutex mutex_;
    std::condition_variable_any over_;
    std::jthread waiting_;  // last: it uses the others
};

}  // namespace stridor::support
