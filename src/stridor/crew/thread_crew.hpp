#pragma once

#include "stridor/crew/crew.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace stridor::crew {

/// The threads of this process.
class ThreadCrew final : public Crew {
public:
    /// Starts `threads` threads; 0: one per processor this process may use. Throws `Error` (io) if the system starts
    /// fewer.
    ThreadCrew(const Work& work, int threads, std::stop_token stop);
    ~ThreadCrew() override;

    std::size_t appetite(std::size_t left) override;
    void give(std::vector<Task> tasks) override;
    std::vector<Result> take(std::size_t enough, Clock::time_point deadline) override;
    bool is_idle() override;
    bool has_stopped() override;
    void rethrow() override;
    double seconds_per_task() override;

private:
    void labour(const Worker& worker);
    void compute(const Task& task, const Worker& worker);
    void keep_failure(std::exception_ptr failure);  // the first one counts
    bool is_news(std::size_t enough);
    bool is_done() const;
    std::size_t hunger() const;

    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_;  // passes the caller's stop request on to halt_

    std::mutex mutex_;                     // guards the members below
    std::condition_variable_any given_;    // there are tasks
    std::condition_variable_any changed_;  // there are results, or there is room for tasks
    std::deque<Task> queue_;               // that nobody has begun
    std::vector<Result> arrived_;
    std::size_t enough_ = 0;  // [1] results the owner waits for
    std::size_t running_ = 0;
    std::size_t finished_ = 0;  // [1] tasks
    double seconds_ = 0.0;      // that these took
    bool was_fed_ = false;      // since the owner was last woken by hunger
    std::exception_ptr failure_;

    std::vector<std::jthread> threads_;  // last, so that they end before what they use
};

/// Returns the number of threads that a user's number means: 0 is one per processor this process may use. Throws
/// `Error` (input) for more than any machine has.
std::size_t thread_count(int asked);

}  // namespace stridor::crew
