#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/store.hpp"
#include "stridor/sweep/study.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

namespace stridor::sweep {

/// Runs being computed on many threads, their cells handed over to one owner.
///
/// Cells arrive in any order; what the owner makes of them must not depend on it. The destructor stops what still runs.
class Workers {
public:
    using Clock = std::chrono::steady_clock;

    /// Starts on the runs, known by the index of their first cell (`evaluate_run`), which must outlive this as the
    /// study must, with so many threads; 0: one per processor this process may use.
    Workers(const Study& study, std::span<const std::size_t> runs, int threads, std::stop_token stop);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// What has arrived since the last call. Waits for `enough` cells, the deadline or the end, whichever comes first.
    std::vector<IndexedCell> take(std::size_t enough, Clock::time_point deadline);

    /// True once nothing runs and everything was taken.
    bool have_ended();

    /// Throws what ended the work early, if anything did.
    void rethrow();

private:
    void compute_all(int threads);
    void compute(std::size_t first, integration::Workspace& workspace);
    void keep_failure(std::exception_ptr failure);  // the first one counts

    const Study& study_;
    std::span<const std::size_t> runs_;
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_;  // passes the caller's stop request on to halt_

    std::mutex mutex_;  // guards the members below
    std::condition_variable changed_;
    std::vector<IndexedCell> arrived_;
    std::size_t enough_ = 0;  // [1] cells the owner waits for
    bool is_over_ = false;
    std::exception_ptr failure_;

    std::jthread conductor_;  // one of the computing threads; last, so that it ends before what it uses
};

}  // namespace stridor::sweep
