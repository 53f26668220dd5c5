#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/crew.hpp"
#include "stridor/sweep/study.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace stridor::sweep {

/// The threads of this process.
class ThreadCrew final : public Crew {
public:
    /// So many threads; 0: one per processor this process may use. The study must outlive them.
    ThreadCrew(const Study& study, int threads, std::stop_token stop);
    ~ThreadCrew() override;

    std::size_t appetite(std::size_t left) override;
    void give(std::vector<std::size_t> runs) override;
    std::vector<IndexedCell> take(std::size_t enough, Clock::time_point deadline) override;
    bool is_idle() override;
    bool has_stopped() override;
    void rethrow() override;
    double seconds_per_run() override;

private:
    void work();
    void compute(std::size_t first, integration::Workspace& workspace);
    void keep_failure(std::exception_ptr failure);  // the first one counts
    bool is_news(std::size_t enough);
    bool is_done() const;
    std::size_t hunger() const;

    const Study& study_;
    const std::size_t stride_;  // [1] from a cell of a run to its next
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_;  // passes the caller's stop request on to halt_

    std::mutex mutex_;                     // guards the members below
    std::condition_variable_any given_;    // there are runs
    std::condition_variable_any changed_;  // there are cells, or there is room for runs
    std::deque<std::size_t> queue_;        // runs that nobody has begun
    std::vector<IndexedCell> arrived_;
    std::size_t enough_ = 0;  // [1] cells the owner waits for
    std::size_t running_ = 0;
    std::size_t finished_ = 0;  // [1] runs
    double seconds_ = 0.0;      // that these took
    bool was_fed_ = false;      // since the owner was last woken by hunger
    std::exception_ptr failure_;

    std::vector<std::jthread> threads_;  // last, so that they end before what they use
};

/// How many threads are meant by a number that a user gave: 0 is one per processor this process may use.
std::size_t thread_count(int asked);

/// Makes crews of so many threads.
CrewMaker thread_crews(int threads);

}  // namespace stridor::sweep
