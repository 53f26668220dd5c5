#include "stridor/sweep/points.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/fork_join.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;

bool is_steady_drive(const DesignPoints& points) {
    return parameters::has_one_phase(points.base.drive);
}

// the same points with full keys
DesignPoints resolved(const DesignPoints& points) {
    DesignPoints result = points;
    for (std::string& key : result.keys) {
        key = parameters::quantity_key_called(key);
        parameters::expect_joint_of(points.base, key);
        if (!parameters::belongs(points.base, key))
            base::refuse(key + " means nothing for this case", "", "Choose a quantity that the case has.");
    }
    return result;
}

void check_keys(const DesignPoints& points) {
    if (points.keys.empty()) base::refuse("there are no points", "no quantity changes", "Give one quantity at least.");
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        for (std::size_t other = 0; other < k; ++other)
            if (parameters::overlap(points.base, points.keys[k], points.keys[other]))
                base::refuse(points.keys[other] + " and " + points.keys[k] + " set the same quantity", "",
                             "Leave one of them out.");
    if (points.values.size() % points.keys.size() != 0)
        base::refuse("the points are not complete", "each has a value of every quantity", "");
}

void check_point_directions(const DesignPoints& points) {
    const auto& directions = points.directions;
    const bool is_twice = directions.size() == 2 && directions.front() == directions.back();
    if (directions.empty() || directions.size() > 2 || is_twice)
        base::refuse("the directions are none, or the same twice", "", "Choose going, coming or both.");
}

// the number of the point that is wrong, in front of what is wrong
[[noreturn]] void refuse_point(std::size_t point, const Error& error) {
    base::Problem problem = error.problem();
    problem.what = "point " + std::to_string(point) + ": " + problem.what;
    throw Error(error.kind(), std::move(problem));
}

void put_values(const DesignPoints& points, std::size_t point, Case& c) {
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        parameters::set_quantity(c, points.keys[k], points.values[point * points.keys.size() + k]);
}

void check_values(const DesignPoints& points) {
    Case c = points.base;
    for (std::size_t point = 0; point < point_count(points); ++point) {
        try {
            put_values(points, point, c);
        } catch (const Error& error) {
            refuse_point(point, error);
        }
    }
}

void check_resolved(const DesignPoints& points) {
    check_keys(points);
    check_point_directions(points);
    check_values(points);
}

/// The runs of all points on many threads, while the calling thread waits.
class PointRuns {
public:
    PointRuns(const DesignPoints& points, std::stop_token stop)
        : points_(points),
          stop_(std::move(stop)),
          cells_(point_count(points) * points.directions.size()),
          runs_(run_count(points)) {}

    void start(int threads) {
        conductor_ = std::jthread([this, threads] { compute_all(threads); });
    }

    // the number of runs done, after so much time or at the end
    std::size_t wait(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        ended_.wait_for(lock, time, [&] { return is_over_; });
        return done_;
    }

    bool has_ended() {
        const std::lock_guard lock(mutex_);
        return is_over_;
    }

    void give_up() { is_given_up_ = true; }

    std::vector<Cell> result() {
        conductor_.join();
        if (failure_) std::rethrow_exception(failure_);
        if (stop_.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {"stopped after " + std::to_string(done_) + " of " + std::to_string(runs_) + " runs",
                         "an evaluation that is stopped keeps nothing", "Run it again."});
        return std::move(cells_);
    }

private:
    bool is_stopped() const { return stop_.stop_requested() || is_given_up_; }

    void compute_all(int threads) {
        namespace tbb = oneapi::tbb;
        const int count = threads > 0 ? threads : tbb::info::default_concurrency();
        // the arena has that many places, the control that many threads, even beyond the number of processors
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
        tbb::task_arena arena(count);
        tbb::enumerable_thread_specific<integration::Workspace> workspaces;
        using IndexRange = tbb::blocked_range<std::size_t>;
        const ForkJoin all;
        const auto compute_range = [&](const IndexRange& range) {
            const ForkJoin::Task task;
            for (std::size_t run = range.begin(); run < range.end() && !is_stopped(); ++run)
                compute(run, workspaces.local());
        };
        try {
            arena.execute(
                [&] { tbb::parallel_for(IndexRange(0, runs_, 1), compute_range, tbb::simple_partitioner()); });
        } catch (...) {
            keep_point_failure(std::current_exception());
        }
        all.join();
        const std::lock_guard lock(mutex_);
        is_over_ = true;
        ended_.notify_one();
    }

    // a run of a constant drive gives one direction, any other all of them
    void compute(std::size_t run, integration::Workspace& workspace) {
        const std::size_t points = point_count(points_);
        const std::size_t first = is_steady_drive(points_) ? run / points : 0;
        const std::size_t last = is_steady_drive(points_) ? first + 1 : points_.directions.size();
        const std::size_t point = run % points;
        try {
            const Case c = case_at(points_, point, points_.directions[first]);
            const std::optional<Attempt> attempted = attempt(c, {}, stop_, workspace);
            if (!attempted) return;
            for (std::size_t k = first; k < last; ++k)
                cells_[k * points + point] = cell_of(c, points_.directions[k], *attempted);
            ++done_;
        } catch (...) {
            // kept here: TBB drops an exception that comes after another
            keep_point_failure(std::current_exception());
            give_up();
        }
    }

    void keep_point_failure(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(failure);
    }

    const DesignPoints& points_;
    std::stop_token stop_;
    std::vector<Cell> cells_;  // shape [direction][point], each written by one task
    std::size_t runs_;
    std::atomic<std::size_t> done_ = 0;
    std::atomic<bool> is_given_up_ = false;

    std::mutex mutex_;  // guards the members below
    std::condition_variable ended_;
    bool is_over_ = false;
    std::exception_ptr failure_;

    std::jthread conductor_;  // last, so that it ends before what it uses
};

}  // namespace

std::size_t point_count(const DesignPoints& points) {
    return points.keys.empty() ? 0 : points.values.size() / points.keys.size();
}

std::size_t run_count(const DesignPoints& points) {
    return point_count(points) * (is_steady_drive(points) ? points.directions.size() : 1);
}

Case case_at(const DesignPoints& points, std::size_t point, Direction direction) {
    Case c = points.base;
    put_values(points, point, c);
    const double sign = direction == Direction::going ? 1.0 : -1.0;
    if (is_steady_drive(points)) c.drive.velocity = std::copysign(c.drive.velocity, sign);
    return c;
}

void check(const DesignPoints& points) {
    check_resolved(resolved(points));
}

std::vector<Cell> evaluate(const DesignPoints& asked, const PointOptions& options) {
    const DesignPoints points = resolved(asked);
    check_resolved(points);
    PointRuns runs(points, options.stop);
    runs.start(options.threads);
    try {
        while (!runs.has_ended()) {
            const std::size_t done = runs.wait(std::chrono::milliseconds(100));
            if (options.progress) options.progress(done);
        }
    } catch (...) {
        runs.give_up();
        throw;
    }
    return runs.result();
}

}  // namespace stridor::sweep
