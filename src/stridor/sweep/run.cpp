#include "stridor/sweep/run.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/workers.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace stridor::sweep {

namespace {

using Clock = Workers::Clock;
using Seconds = std::chrono::duration<double>;

// ten reports a second: more than an eye follows, and a reaction to a stop within that time
constexpr auto tick = std::chrono::milliseconds(100);
constexpr Seconds rate_window{60.0};

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

// the marks of the cells that are kept; shape [cell]
std::vector<int> stored_marks(const Study& study, CellKeeper& keeper) {
    std::vector<int> marks(cell_count(study), unknown_mark);
    const std::vector<bool> stored = keeper.stored();
    STRIDOR_EXPECT(stored.size() == marks.size());
    if (study.refine == 0)
        std::transform(stored.begin(), stored.end(), marks.begin(),
                       [&](bool is_there) { return is_there ? 0 : unknown_mark; });
    else
        keeper.visit(0, marks.size(),
                     [&](const IndexedCell& indexed) { marks[indexed.index] = mark_of(study, indexed.cell); });
    return marks;
}

// the one owner of finished cells: writes them in batches and says how far the sweep is
class Ledger {
public:
    Ledger(const Study& study, CellKeeper& keeper, const RunOptions& options)
        : study_(study),
          keeper_(keeper),
          options_(options),
          marks_(stored_marks(study, keeper)) {
        progress_.counts = keeper.counts();
    }

    std::size_t computed() const { return computed_; }
    const Progress& progress() const { return progress_; }
    std::span<const int> marks() const { return marks_; }

    // so many cells are to come before anything else is known to be needed
    void expect(std::size_t cells) {
        progress_.total = study_.refine == 0 ? cell_count(study_) : known() + cells;
        progress_.done = progress_.total - cells;
        report(Clock::now());
    }

    void take(std::vector<IndexedCell> cells) {
        for (const IndexedCell& indexed : cells) {
            count(progress_.counts, verdict_of(indexed.cell));
            marks_[indexed.index] = mark_of(study_, indexed.cell);
        }
        computed_ += cells.size();
        progress_.done += cells.size();
        std::move(cells.begin(), cells.end(), std::back_inserter(batch_));
        const Clock::time_point now = Clock::now();
        const bool is_due = Seconds(now - written_).count() >= options_.seconds_per_commit;
        if (batch_.size() >= options_.cells_per_commit || is_due) write();
        if (now - reported_ >= tick) report(now);
    }

    void end_round() {
        write();
        options_.round();
    }

    void finish() {
        write();
        report(Clock::now());
    }

private:
    void write() {
        if (!batch_.empty()) keeper_.write(batch_);
        batch_.clear();
        written_ = Clock::now();
    }

    void report(Clock::time_point now) {
        rate_.note(now, progress_.done);
        progress_.rate = rate_.value();
        reported_ = now;
        if (options_.progress) options_.progress(progress_);
    }

    std::size_t known() const {
        return marks_.size() - static_cast<std::size_t>(std::count(marks_.begin(), marks_.end(), unknown_mark));
    }

    const Study& study_;
    CellKeeper& keeper_;
    const RunOptions& options_;
    std::vector<int> marks_;  // of the finished cells; shape [cell]
    Progress progress_;
    Rate rate_;
    std::vector<IndexedCell> batch_;
    std::size_t computed_ = 0;
    Clock::time_point written_ = Clock::now();
    Clock::time_point reported_;
};

}  // namespace

RunReport run(const Study& study, CellKeeper& keeper, const RunOptions& options) {
    STRIDOR_EXPECT(options.threads >= 0 && options.cells_per_commit > 0);
    Ledger ledger(study, keeper, options);
    std::vector<std::size_t> missing = refine(study, ledger.marks()).missing;
    ledger.expect(missing.size() * directions_per_run(study));
    // a complete chart has one round, a refined one as many as its boundaries take to be followed; cells are written
    // when enough of them or of time has gathered, for a write waits for the disk
    while (!missing.empty()) {
        Workers workers(study, missing, options.threads, options.stop);
        while (!workers.have_ended())
            ledger.take(workers.take(options.cells_per_commit, Clock::now() + tick));
        const bool was_stopped = ledger.progress().done < ledger.progress().total;
        if (was_stopped) {
            // what was finished is kept before anybody hears of a failure
            ledger.finish();
            workers.rethrow();
            return {SweepEnding::stopped, ledger.computed(), ledger.progress()};
        }
        missing = refine(study, ledger.marks()).missing;
        if (missing.empty()) break;
        if (options.round) ledger.end_round();
        ledger.expect(missing.size() * directions_per_run(study));
    }
    ledger.finish();
    return {SweepEnding::completed, ledger.computed(), ledger.progress()};
}

}  // namespace stridor::sweep
