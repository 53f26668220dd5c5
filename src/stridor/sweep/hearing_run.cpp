#include "stridor/sweep/hearing_run.hpp"

#include "stridor/base/error.hpp"
#include "stridor/sweep/store.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <utility>

namespace stridor::sweep {

namespace {

using Clock = std::chrono::steady_clock;

// what the computing threads tell the caller's
class Desk {
public:
    explicit Desk(std::size_t total) : begin_(Clock::now()) { progress_.total = total; }

    void note(std::span<const HeardSound> sounds) {
        const std::lock_guard lock(mutex_);
        for (const HeardSound& sound : sounds)
            count(progress_.counts, verdict_of(sound.cell));
        progress_.done += sounds.size();
    }

    void keep(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(failure);  // the first one counts
    }

    void close() {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
        changed_.notify_one();
    }

    // waits for the end, and says now and then how far it is
    void watch(const std::function<void(const Progress&)>& report) {
        std::unique_lock lock(mutex_);
        for (bool is_over = false; !is_over;) {
            is_over = changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return is_over_; });
            const double time = std::chrono::duration<double>(Clock::now() - begin_).count();
            progress_.rate = static_cast<double>(progress_.done) / time;
            if (!report) continue;
            const Progress now = progress_;
            lock.unlock();
            report(now);
            lock.lock();
        }
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    Clock::time_point begin_;
    std::mutex mutex_;
    std::condition_variable changed_;
    Progress progress_;
    std::exception_ptr failure_;
    bool is_over_ = false;
};

// all cells of a study, by index
class Hearing {
public:
    Hearing(const Study& study, const HearingOptions& options)
        : study_(study),
          options_(options),
          points_(cell_count(study) / study.directions.size()),
          together_(directions_per_run(study)),
          desk(cell_count(study)),
          sounds(cell_count(study)) {}

    // one run after the other, each a task of its own: it takes milliseconds to seconds
    void compute() {
        try {
            const int count = options_.threads > 0 ? options_.threads : tbb::info::default_concurrency();
            tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
            tbb::task_arena arena(count);
            tbb::enumerable_thread_specific<integration::Workspace> workspaces;
            using Range = tbb::blocked_range<std::size_t>;
            const std::size_t runs = sounds.size() / together_;
            const auto compute_range = [&](const Range& range) {
                for (std::size_t run = range.begin(); run < range.end() && !stops(); ++run)
                    compute(run, workspaces.local());
            };
            arena.execute([&] { tbb::parallel_for(Range(0, runs, 1), compute_range, tbb::simple_partitioner()); });
        } catch (...) {
            desk.keep(std::current_exception());
        }
        desk.close();
    }

    bool stops() const { return halt_.stop_requested() || options_.stop.stop_requested(); }

private:
    const Study& study_;
    const HearingOptions& options_;
    std::size_t points_;    // [1] of the grid
    std::size_t together_;  // [1] directions that one run gives
    std::stop_source halt_;

    void compute(std::size_t first, integration::Workspace& workspace) {
        const CellPlace place = place_of(study_, first);
        HearingSettings settings = options_.settings;
        if (options_.perturb_every > 0 && first % options_.perturb_every == 0) settings.seed = first;
        try {
            const std::span directions = std::span(study_.directions).subspan(place.direction, together_);
            const std::stop_callback relay(options_.stop, [this] { halt_.request_stop(); });
            std::vector<HeardSound> heard =
                hear(case_at(study_, place), directions, settings, halt_.get_token(), workspace);
            desk.note(heard);
            for (std::size_t k = 0; k < heard.size(); ++k) {
                heard[k].index = first + k * points_;
                sounds[heard[k].index] = std::move(heard[k]);
            }
        } catch (...) {
            desk.keep(std::current_exception());
            halt_.request_stop();  // the others need not finish what will not be used
        }
    }

public:
    Desk desk;
    std::vector<HeardSound> sounds;  // shape [cell]
};

}  // namespace

std::vector<HeardSound> hear(const Study& study, const HearingOptions& options) {
    if (!study.starts.empty())
        throw Error(ErrorKind::input, {"the chart has several starts", "a sound is that of one motion",
                                       "Leave chart.starts out; run.initial is the start that is heard."});
    check_audible(study.base, options.settings);
    Hearing hearing(study, options);
    {
        const std::jthread conductor([&] { hearing.compute(); });
        hearing.desk.watch(options.progress);
    }
    if (options.stop.stop_requested()) return {};
    return std::move(hearing.sounds);
}

}  // namespace stridor::sweep
