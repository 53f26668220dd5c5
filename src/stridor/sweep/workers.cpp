#include "stridor/sweep/workers.hpp"

#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/fork_join.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <utility>

namespace stridor::sweep {

Workers::Workers(const Study& study, std::span<const std::size_t> runs, int threads, std::stop_token stop)
    : study_(study),
      runs_(runs),
      relay_(std::move(stop), [this] { halt_.request_stop(); }) {
    conductor_ = std::jthread([this, threads] { compute_all(threads); });
}

Workers::~Workers() {
    halt_.request_stop();
}

void Workers::compute_all(int threads) {
    try {
        const int count = threads > 0 ? threads : tbb::info::default_concurrency();
        // the arena has that many places, the control that many threads, even beyond the number of processors
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
        tbb::task_arena arena(count);
        tbb::task_group_context context;
        using IndexRange = tbb::blocked_range<std::size_t>;
        tbb::enumerable_thread_specific<integration::Workspace> workspaces;
        const ForkJoin all;
        const auto compute_range = [&](const IndexRange& range) {
            const ForkJoin::Task task;
            for (std::size_t k = range.begin(); k < range.end() && !halt_.stop_requested(); ++k)
                compute(runs_[k], workspaces.local());
            if (halt_.stop_requested()) context.cancel_group_execution();
        };
        // a run takes milliseconds to minutes: each is a task of its own
        arena.execute([&] {
            tbb::parallel_for(IndexRange(0, runs_.size(), 1), compute_range, tbb::simple_partitioner(), context);
        });
        all.join();
    } catch (...) {
        keep_failure(std::current_exception());
    }
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    changed_.notify_one();
}

void Workers::keep_failure(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
}

void Workers::compute(std::size_t first, integration::Workspace& workspace) {
    std::vector<Cell> cells;
    try {
        cells = evaluate_run(study_, first, halt_.get_token(), workspace);
    } catch (...) {
        // kept here: TBB drops an exception that comes after another worker has cancelled the group
        keep_failure(std::current_exception());
        // the others need not finish what will not be used
        halt_.request_stop();
        return;
    }
    const std::lock_guard lock(mutex_);
    // the same place in one direction after the other
    const std::size_t points = cell_count(study_) / study_.directions.size();
    for (std::size_t k = 0; k < cells.size(); ++k)
        arrived_.push_back({first + k * points, std::move(cells[k])});
    if (arrived_.size() >= enough_) changed_.notify_one();
}

std::vector<IndexedCell> Workers::take(std::size_t enough, Clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    enough_ = enough;
    changed_.wait_until(lock, deadline, [&] { return is_over_ || arrived_.size() >= enough_; });
    return std::exchange(arrived_, {});
}

bool Workers::have_ended() {
    const std::lock_guard lock(mutex_);
    return is_over_ && arrived_.empty();
}

void Workers::rethrow() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
}

}  // namespace stridor::sweep
