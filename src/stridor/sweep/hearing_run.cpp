#include "stridor/sweep/hearing_run.hpp"

#include "stridor/base/error.hpp"
#include "stridor/sweep/run_sound.hpp"
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

// all cells of a study on many threads
class Hearing {
public:
    Hearing(const Study& study, const HearingOptions& options)
        : study_(study),
          options_(options),
          desk_(cell_count(study)),
          sounds_(cell_count(study)) {}

    // tells the desk when it is done, whatever happens
    void compute() {
        try {
            compute_all();
        } catch (...) {
            desk_.keep(std::current_exception());
        }
        desk_.close();
    }

    Desk& desk() { return desk_; }
    std::vector<HeardSound> take() { return std::move(sounds_); }

private:
    // each run is a task of its own: it takes milliseconds to seconds
    void compute_all() {
        const int count = options_.threads > 0 ? options_.threads : tbb::info::default_concurrency();
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
        tbb::task_arena arena(count);
        tbb::enumerable_thread_specific<integration::Workspace> workspaces;
        using Range = tbb::blocked_range<std::size_t>;
        const auto compute_range = [&](const Range& range) {
            for (std::size_t run = range.begin(); run < range.end() && !halt_.stop_requested(); ++run)
                compute(run, workspaces.local());
        };
        const std::size_t runs = sounds_.size() / directions_per_run(study_);
        arena.execute([&] { tbb::parallel_for(Range(0, runs, 1), compute_range, tbb::simple_partitioner()); });
    }

    // the cells of the run whose first cell has this index
    void compute(std::size_t first, integration::Workspace& workspace) {
        const CellPlace place = place_of(study_, first);
        const std::span directions = std::span(study_.directions).subspan(place.direction, directions_per_run(study_));
        const std::size_t points = sounds_.size() / study_.directions.size();
        HearingSettings settings = options_.settings;
        if (options_.perturb_every > 0 && first % options_.perturb_every == 0) settings.seed = first;
        try {
            std::vector<HeardSound> heard =
                hear(case_at(study_, place), directions, settings, halt_.get_token(), workspace);
            for (std::size_t k = 0; k < heard.size(); ++k)
                heard[k].index = first + k * points;
            desk_.note(heard);
            for (HeardSound& sound : heard)
                sounds_[sound.index] = std::move(sound);
        } catch (...) {
            // kept here: TBB drops an exception that comes after another
            desk_.keep(std::current_exception());
            halt_.request_stop();  // the others need not finish what will not be used
        }
    }

    const Study& study_;
    const HearingOptions& options_;
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_{options_.stop, [this] { halt_.request_stop(); }};
    Desk desk_;
    std::vector<HeardSound> sounds_;  // shape [cell]
};

}  // namespace

std::vector<HeardSound> hear(const Study& study, const HearingOptions& options) {
    if (!study.starts.empty())
        throw Error(ErrorKind::input, {"the chart has several starts", "a sound is that of one motion",
                                       "Leave chart.starts out; run.initial is the start that is heard."});
    check_audible(study.base, options.settings.sound);
    Hearing hearing(study, options);
    {
        const std::jthread conductor([&] { hearing.compute(); });
        hearing.desk().watch(options.progress);
    }
    if (options.stop.stop_requested()) return {};
    return hearing.take();
}

}  // namespace stridor::sweep
