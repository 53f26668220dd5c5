#include "stridor/sweep/thread_crew.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <oneapi/tbb/info.h>

#include <algorithm>
#include <utility>

namespace stridor::sweep {

namespace {

// what waits in the queue lasts so long: the owner, who writes to a disk, comes back sooner
constexpr double queued_seconds = 0.1;
constexpr std::size_t most_queued = 4096;  // [1] runs

}  // namespace

ThreadCrew::ThreadCrew(const Study& study, int threads, std::stop_token stop)
    : study_(study),
      stride_(cell_count(study) / study.directions.size()),
      relay_(std::move(stop), [this] { halt_.request_stop(); }) {
    for (std::size_t count = thread_count(threads); count > 0; --count)
        threads_.emplace_back([this] { work(); });
}

ThreadCrew::~ThreadCrew() {
    halt_.request_stop();
}

void ThreadCrew::work() {
    integration::Workspace workspace;
    std::unique_lock lock(mutex_);
    while (given_.wait(lock, halt_.get_token(), [&] { return !queue_.empty(); }) && !halt_.stop_requested()) {
        const std::size_t first = queue_.front();
        queue_.pop_front();
        ++running_;
        lock.unlock();
        compute(first, workspace);
        lock.lock();
        --running_;
        if (is_news(enough_)) changed_.notify_one();
    }
    changed_.notify_one();
}

void ThreadCrew::compute(std::size_t first, integration::Workspace& workspace) {
    const Clock::time_point begin = Clock::now();
    std::vector<Cell> cells;
    try {
        cells = evaluate_run(study_, first, halt_.get_token(), workspace);
    } catch (...) {
        keep_failure(std::current_exception());
        // the others need not finish what will not be used
        halt_.request_stop();
        return;
    }
    const std::lock_guard lock(mutex_);
    seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
    ++finished_;
    // the same place in one direction after the other
    for (std::size_t k = 0; k < cells.size(); ++k)
        arrived_.push_back({first + k * stride_, std::move(cells[k])});
}

void ThreadCrew::keep_failure(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
}

std::size_t ThreadCrew::hunger() const {
    // before the first has ended nobody knows: two for each
    std::size_t wanted = 2 * threads_.size();
    if (finished_ > 0) {
        const double mean = std::max(seconds_ / static_cast<double>(finished_), 1e-9);
        const double runs = queued_seconds * static_cast<double>(threads_.size()) / mean;
        wanted = std::max(wanted, static_cast<std::size_t>(std::min(runs, static_cast<double>(most_queued))));
    }
    return 2 * queue_.size() > wanted ? 0 : wanted - queue_.size();
}

std::size_t ThreadCrew::appetite(std::size_t left) {
    const std::lock_guard lock(mutex_);
    return halt_.stop_requested() ? 0 : std::min(hunger(), left);
}

void ThreadCrew::give(std::vector<std::size_t> runs) {
    const std::lock_guard lock(mutex_);
    queue_.insert(queue_.end(), runs.begin(), runs.end());
    was_fed_ = true;
    given_.notify_all();
}

bool ThreadCrew::is_done() const {
    return running_ == 0 && (queue_.empty() || halt_.stop_requested());
}

bool ThreadCrew::is_news(std::size_t enough) {
    return is_done() || arrived_.size() >= enough || (was_fed_ && hunger() > 0);
}

std::vector<IndexedCell> ThreadCrew::take(std::size_t enough, Clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    enough_ = enough;
    changed_.wait_until(lock, deadline, [&] { return is_news(enough); });
    // he is told once that there is room: he may have nothing to give
    if (hunger() > 0) was_fed_ = false;
    return std::exchange(arrived_, {});
}

bool ThreadCrew::is_idle() {
    const std::lock_guard lock(mutex_);
    return is_done() && arrived_.empty();
}

bool ThreadCrew::has_stopped() {
    return halt_.stop_requested();
}

void ThreadCrew::rethrow() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
}

double ThreadCrew::seconds_per_run() {
    const std::lock_guard lock(mutex_);
    return finished_ > 0 ? seconds_ / static_cast<double>(finished_) : 0.0;
}

std::size_t thread_count(int asked) {
    STRIDOR_EXPECT(asked >= 0);
    return static_cast<std::size_t>(asked > 0 ? asked : tbb::info::default_concurrency());
}

CrewMaker thread_crews(int threads) {
    return [threads](const Study& study, const std::stop_token& stop) {
        return std::make_unique<ThreadCrew>(study, threads, stop);
    };
}

}  // namespace stridor::sweep
