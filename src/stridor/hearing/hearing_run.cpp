#include "stridor/hearing/hearing_run.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/hearing/heard_text.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/sweep/fork_join.hpp"
#include "stridor/sweep/store/store.hpp"

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
#include <optional>
#include <span>
#include <thread>
#include <utility>

namespace stridor::hearing {

namespace {

using Clock = std::chrono::steady_clock;

// what the computing threads tell the caller's
class Desk {
public:
    explicit Desk(std::size_t total) : begin_(Clock::now()) { progress_.total = total; }

    void note(std::span<const HeardSound> sounds, bool are_new) {
        const std::lock_guard lock(mutex_);
        if (!are_new) known_ += sounds.size();
        for (const HeardSound& sound : sounds)
            sweep::count(progress_.counts, sweep::verdict_of(sound.cell));
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
    void watch(const std::function<void(const sweep::Progress&)>& report) {
        std::unique_lock lock(mutex_);
        for (bool is_over = false; !is_over;) {
            is_over = changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return is_over_; });
            const double time = std::chrono::duration<double>(Clock::now() - begin_).count();
            progress_.rate = static_cast<double>(progress_.done - known_) / time;
            if (!report) continue;
            const sweep::Progress now = progress_;
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
    sweep::Progress progress_;
    std::size_t known_ = 0;  // [1] of the finished cells, those that were heard before
    std::exception_ptr failure_;
    bool is_over_ = false;
};

// all cells of a study on many threads
class Hearing {
public:
    Hearing(const sweep::Study& study, const HearingOptions& options)
        : study_(study),
          options_(options),
          desk_(sweep::cell_count(study)),
          sounds_(sweep::cell_count(study)) {}

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
        using IndexRange = tbb::blocked_range<std::size_t>;
        const sweep::ForkJoin all;
        const auto compute_range = [&](const IndexRange& range) {
            const sweep::ForkJoin::Task task;
            for (std::size_t run = range.begin(); run < range.end() && !halt_.stop_requested(); ++run)
                compute(run, workspaces.local());
        };
        const std::size_t runs = sounds_.size() / sweep::directions_per_run(study_);
        arena.execute([&] { tbb::parallel_for(IndexRange(0, runs, 1), compute_range, tbb::simple_partitioner()); });
        all.join();
    }

    // the cells of the run whose first cell has this index
    void compute(std::size_t first, integration::Workspace& workspace) {
        const sweep::CellPlace place = sweep::place_of(study_, first);
        const std::span directions =
            std::span(study_.directions).subspan(place.direction, sweep::directions_per_run(study_));
        const std::size_t points = sounds_.size() / study_.directions.size();
        HearingSettings settings = options_.settings;
        if (options_.perturb_every > 0 && first % options_.perturb_every == 0) settings.seed = first;
        try {
            std::vector<HeardSound> heard = kept(first, directions.size());
            const bool is_new = heard.empty();
            if (is_new) heard = hear(sweep::case_at(study_, place), directions, settings, halt_.get_token(), workspace);
            for (std::size_t k = 0; k < heard.size(); ++k)
                heard[k].index = first + k * points;
            if (is_new && !heard.empty() && options_.kept != nullptr) options_.kept->keep(first, packed(heard));
            desk_.note(heard, is_new);
            for (HeardSound& sound : heard)
                sounds_[sound.index] = std::move(sound);
        } catch (...) {
            // kept here: TBB drops an exception that comes after another
            desk_.keep(std::current_exception());
            halt_.request_stop();  // the others need not finish what will not be used
        }
    }

    // the sounds of a run that was heard before; none if it was not
    std::vector<HeardSound> kept(std::size_t first, std::size_t directions) const {
        if (options_.kept == nullptr) return {};
        const std::optional<std::string> text = options_.kept->find(first);
        if (!text) return {};
        std::optional<std::vector<HeardSound>> sounds = unpacked_heard_sounds(*text);
        return sounds && sounds->size() == directions ? std::move(*sounds) : std::vector<HeardSound>{};
    }

    const sweep::Study& study_;
    const HearingOptions& options_;
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_{options_.stop, [this] { halt_.request_stop(); }};
    Desk desk_;
    std::vector<HeardSound> sounds_;  // shape [cell]
};

}  // namespace

std::string heard_text(const sweep::Study& study, const HearingOptions& options) {
    const HearingSettings& settings = options.settings;
    std::string text = sweep::canonical_text(study);
    const auto add = [&](const std::string& key, double value) {
        text += "heard." + key + " = " + base::shortest(value) + "\n";
    };
    add("results", sweep::results_version);
    text += "heard.of = " + settings.motion.of + " " + settings.motion.component + "\n";
    add("quantity", static_cast<double>(settings.motion.quantity));
    if (study.base.own_structure)
        for (const parameters::OwnOutput& output : study.base.own_structure->outputs) {
            text += "heard.output = " + output.name + "\n";
            for (const double weight : output.weights)
                add("weight", weight);
        }
    add("rate", settings.sound.rate);
    add("high_pass", settings.sound.high_pass);
    add("fade", settings.sound.fade);
    add("density", settings.sound.density);
    add("perturb_every", static_cast<double>(options.perturb_every));
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        add(std::string(threshold.name), settings.thresholds.*threshold.member);
    return text;
}

std::vector<HeardSound> hear(const sweep::Study& study, const HearingOptions& options) {
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

}  // namespace stridor::hearing
