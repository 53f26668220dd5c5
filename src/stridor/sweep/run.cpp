#include "stridor/sweep/run.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/workers.hpp"

#include <chrono>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace stridor::sweep {

namespace {

using Clock = Workers::Clock;
using Seconds = std::chrono::duration<double>;

// ten reports a second: more than an eye follows, and a reaction to a stop within that time
constexpr auto tick = std::chrono::milliseconds(100);
constexpr Seconds rate_window{60.0};

// points of which a cell of some direction is missing, in index order
std::vector<std::size_t> missing_points(const Study& study, const std::vector<bool>& stored) {
    const std::size_t points = static_cast<std::size_t>(study.x.points) * static_cast<std::size_t>(study.y.points);
    std::vector<std::size_t> missing;
    for (std::size_t point = 0; point < points; ++point)
        for (std::size_t direction = 0; direction < study.directions.size(); ++direction)
            if (!stored[direction * points + point]) {
                missing.push_back(point);
                break;
            }
    return missing;
}

// cells per second over the last minute
class Rate {
public:
    void note(Clock::time_point now, std::size_t done) {
        history_.push_back({now, done});
        while (history_.size() > 2 && now - history_[1].time > rate_window)
            history_.pop_front();
    }

    double value() const {
        const double time = Seconds(history_.back().time - history_.front().time).count();
        return time > 0.0 ? static_cast<double>(history_.back().done - history_.front().done) / time : 0.0;
    }

private:
    struct Note {
        Clock::time_point time;
        std::size_t done;
    };
    std::deque<Note> history_;
};

// the one owner of finished cells: writes them in batches and says how far the sweep is
class Ledger {
public:
    Ledger(const Study& study, Store& store, const RunOptions& options, std::size_t done)
        : store_(store),
          options_(options) {
        progress_.total = cell_count(study);
        progress_.done = done;
        progress_.counts = store.counts();
        report(Clock::now());
    }

    std::size_t computed() const { return computed_; }
    const Progress& progress() const { return progress_; }

    void take(std::vector<IndexedCell> cells) {
        for (const IndexedCell& indexed : cells)
            count(progress_.counts, indexed.cell);
        computed_ += cells.size();
        progress_.done += cells.size();
        std::move(cells.begin(), cells.end(), std::back_inserter(batch_));
        const Clock::time_point now = Clock::now();
        const bool is_due = Seconds(now - written_).count() >= options_.seconds_per_commit;
        if (batch_.size() >= options_.cells_per_commit || is_due) write();
        if (now - reported_ >= tick) report(now);
    }

    void finish() {
        write();
        report(Clock::now());
    }

private:
    void write() {
        if (!batch_.empty()) store_.write(batch_);
        batch_.clear();
        written_ = Clock::now();
    }

    void report(Clock::time_point now) {
        rate_.note(now, progress_.done);
        progress_.rate = rate_.value();
        reported_ = now;
        if (options_.progress) options_.progress(progress_);
    }

    Store& store_;
    const RunOptions& options_;
    Progress progress_;
    Rate rate_;
    std::vector<IndexedCell> batch_;
    std::size_t computed_ = 0;
    Clock::time_point written_ = Clock::now();
    Clock::time_point reported_;
};

}  // namespace

RunReport run(const Study& study, Store& store, const RunOptions& options) {
    STRIDOR_EXPECT(options.threads >= 0 && options.cells_per_commit > 0);
    const std::vector<bool> stored = store.stored();
    STRIDOR_EXPECT(stored.size() == cell_count(study));
    const std::vector<std::size_t> missing = missing_points(study, stored);
    const std::size_t unfinished = missing.size() * study.directions.size();
    Ledger ledger(study, store, options, cell_count(study) - unfinished);
    if (!missing.empty()) {
        Workers workers(study, missing, options.threads, options.stop);
        while (!workers.have_ended())
            ledger.take(workers.take(options.cells_per_commit, Clock::now() + tick));
        // what was finished is kept before anybody hears of a failure
        ledger.finish();
        workers.rethrow();
    }
    const Ending ending = ledger.computed() == unfinished ? Ending::completed : Ending::stopped;
    return {ending, ledger.computed(), ledger.progress()};
}

}  // namespace stridor::sweep
