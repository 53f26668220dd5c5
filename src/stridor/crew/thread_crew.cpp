#include "stridor/crew/thread_crew.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"

#include <sched.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace stridor::crew {

namespace {

// what waits in the queue lasts so long: the owner, who writes to a disk, comes back sooner
constexpr double queued_seconds = 0.1;
constexpr std::size_t most_queued = 4096;  // [1] tasks

// more than any machine has processors; each takes memory of its own, whether it has something to do or not
constexpr int most_threads = 4096;  // [1]

// those that this process may use, which may be fewer than the machine has
int usable_processors() {
    cpu_set_t usable;
    if (sched_getaffinity(0, sizeof usable, &usable) == 0) return CPU_COUNT(&usable);
    // more than a set of the usual size can name
    return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
}

}  // namespace

ThreadCrew::ThreadCrew(const Work& work, int threads, std::stop_token stop)
    : relay_(std::move(stop), [this] { halt_.request_stop(); }) {
    try {
        for (std::size_t count = thread_count(threads); count > 0; --count)
            threads_.emplace_back([this, worker = work.worker()] { labour(worker); });
    } catch (const std::system_error& failure) {
        // those that have begun wait for tasks, and are waited for
        halt_.request_stop();
        throw base::no_thread(failure);
    } catch (...) {
        halt_.request_stop();
        throw;
    }
}

ThreadCrew::~ThreadCrew() {
    halt_.request_stop();
}

void ThreadCrew::labour(const Worker& worker) {
    std::unique_lock lock(mutex_);
    while (given_.wait(lock, halt_.get_token(), [&] { return !queue_.empty(); }) && !halt_.stop_requested()) {
        const Task task = std::move(queue_.front());
        queue_.pop_front();
        ++running_;
        lock.unlock();
        compute(task, worker);
        lock.lock();
        --running_;
        if (is_news(enough_)) changed_.notify_one();
    }
    changed_.notify_one();
}

void ThreadCrew::compute(const Task& task, const Worker& worker) {
    const Clock::time_point begin = Clock::now();
    std::optional<std::string> bytes;
    try {
        bytes = worker(task, halt_.get_token());
    } catch (...) {
        keep_failure(std::current_exception());
        // the others need not finish what will not be used
        halt_.request_stop();
    }
    if (!bytes) return;
    const std::lock_guard lock(mutex_);
    seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
    ++finished_;
    arrived_.push_back({task.number, std::move(*bytes)});
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
        const double tasks = queued_seconds * static_cast<double>(threads_.size()) / mean;
        wanted = std::max(wanted, static_cast<std::size_t>(std::min(tasks, static_cast<double>(most_queued))));
    }
    return 2 * queue_.size() > wanted ? 0 : wanted - queue_.size();
}

std::size_t ThreadCrew::appetite(std::size_t left) {
    const std::lock_guard lock(mutex_);
    return halt_.stop_requested() ? 0 : std::min(hunger(), left);
}

void ThreadCrew::give(std::vector<Task> tasks) {
    const std::lock_guard lock(mutex_);
    std::move(tasks.begin(), tasks.end(), std::back_inserter(queue_));
    was_fed_ = true;
    given_.notify_all();
}

bool ThreadCrew::is_done() const {
    return running_ == 0 && (queue_.empty() || halt_.stop_requested());
}

bool ThreadCrew::is_news(std::size_t enough) {
    return is_done() || arrived_.size() >= enough || (was_fed_ && hunger() > 0);
}

std::vector<Result> ThreadCrew::take(std::size_t enough, Clock::time_point deadline) {
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

double ThreadCrew::seconds_per_task() {
    const std::lock_guard lock(mutex_);
    return finished_ > 0 ? seconds_ / static_cast<double>(finished_) : 0.0;
}

std::size_t thread_count(int asked) {
    STRIDOR_EXPECT(asked >= 0);
    if (asked > most_threads)
        base::refuse(std::to_string(asked) + " threads are too many",
                     "a process has " + std::to_string(most_threads) + " at most",
                     "One per processor is best, which is what it does without being told.");
    return static_cast<std::size_t>(asked > 0 ? asked : usable_processors());
}

CrewMaker thread_crews(int threads) {
    STRIDOR_EXPECT(threads >= 0);
    return [threads](const Work& work, const std::stop_token& stop) {
        return std::make_unique<ThreadCrew>(work, threads, stop);
    };
}

}  // namespace stridor::crew
