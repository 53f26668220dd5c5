#pragma once

#include "support/effort.hpp"

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <stop_token>
#include <thread>

namespace stridor::support {

/// Somebody who waits so long [s] for a run and then presses Ctrl-C; and whether the run took long to end after that.
/// The time is the processor's for this process: on a busy machine nobody waits for what others compute.
class Patience {
public:
    explicit Patience(double seconds)
        : waiting_([this, end = processor_time() + seconds](const std::stop_token& leave) {
              std::unique_lock lock(mutex_);
              while (processor_time() < end)
                  if (over_.wait_for(lock, leave, std::chrono::milliseconds(5), [&] { return leave.stop_requested(); }))
                      return;
              pressed_ = processor_time();
              has_pressed_ = true;
              stop_.request_stop();
          }) {}

    std::stop_token token() const { return stop_.get_token(); }

    /// Has the run gone on for more than a second after Ctrl-C? Sanitizers get ten.
    bool is_worn_out() {
        const std::lock_guard lock(mutex_);
        return has_pressed_ && processor_time() - pressed_ > static_cast<double>(effort(1, 10));
    }

private:
    static double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

    double pressed_ = 0.0;
    bool has_pressed_ = false;
    std::stop_source stop_;
    std::mutex mutex_;
    std::condition_variable_any over_;
    std::jthread waiting_;  // last: it uses the others
};

}  // namespace stridor::support
