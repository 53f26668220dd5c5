#include "stridor/sweep/run.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/study_work.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace stridor::sweep {

namespace {

using Clock = crew::Crew::Clock;
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

// the one owner of finished cells: writes them in batches and says how far the sweep is
class Ledger {
public:
    Ledger(CellKeeper& keeper, const RunOptions& options) : keeper_(keeper), options_(options) {
        progress_.counts = keeper.counts();
    }

    std::size_t computed() const { return computed_; }
    const Progress& progress() const { return progress_; }

    // so many cells are there, and so many are to come before anything else is known to be needed
    void expect(std::size_t there, std::size_t to_come) {
        progress_.total = there + to_come;
        progress_.done = there;
        report(Clock::now());
    }

    void take(std::vector<IndexedCell> cells) {
        for (const IndexedCell& indexed : cells)
            count(progress_.counts, verdict_of(indexed.cell));
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
        // in index order, in which a store takes them ten times as fast as in any
        std::sort(batch_.begin(), batch_.end(),
                  [](const IndexedCell& a, const IndexedCell& b) { return a.index < b.index; });
        if (!batch_.empty()) keeper_.write(batch_);
        batch_.clear();
        written_ = Clock::now();
    }

    void report(Clock::time_point now) {
        rate_.note(now, progress_.done);
        progress_.rate = rate_.value();
        reported_ = now;
        if (!options_.progress) return;
        try {
            options_.progress(progress_);
        } catch (...) {
            // what it throws costs no cell
            write();
            throw;
        }
    }

    CellKeeper& keeper_;
    const RunOptions& options_;
    Progress progress_;
    Rate rate_;
    std::vector<IndexedCell> batch_;
    std::size_t computed_ = 0;
    Clock::time_point written_ = Clock::now();
    Clock::time_point reported_;
};

// what is known of the study, and what is to be computed next
class Plan {
public:
    Plan(const Study& study, CellKeeper& keeper, const RunOptions& options)
        : study_(study),
          options_(options),
          agenda_(cell_count(study)) {
        if (study.refine == 0) {
            add_all_but(keeper.stored());
            return;
        }
        marks_.assign(cell_count(study), unknown_mark);
        keeper.visit(0, marks_.size(),
                     [&](const IndexedCell& indexed) { marks_[indexed.index] = mark_of(study, indexed.cell); });
        look();
    }

    Agenda& agenda() { return agenda_; }
    std::size_t there() const { return there_; }      // [1] cells of this share that were known at the last look
    std::size_t to_come() const { return to_come_; }  // [1] cells of this share that were missing then

    void note(std::span<const IndexedCell> cells) {
        since_ += cells.size();
        if (study_.refine == 0) return;
        for (const IndexedCell& indexed : cells)
            marks_[indexed.index] = mark_of(study_, indexed.cell);
    }

    // Has enough become known for another look, which costs as much as there are cells? What is asked of a cell never
    // depends on when it became known (refinement.hpp), so a look may come before all is there that was asked for.
    bool is_worth_a_look(bool is_idle) const {
        if (study_.refine == 0 || since_ == 0) return false;
        const bool is_round = options_.round != nullptr;
        return is_idle || (!is_round && since_ >= std::max<std::size_t>(there_ / 100, 1));
    }

    void look() {
        since_ = 0;
        std::size_t missing = 0;
        for (const std::size_t run : refine(study_, marks_).missing) {
            if (!is_in(options_.share, study_, run)) continue;
            ++missing;
            agenda_.add(run);
        }
        to_come_ = missing * directions_per_run(study_);
        there_ = 0;
        for (std::size_t index = 0; index < marks_.size(); ++index)
            there_ += marks_[index] != unknown_mark && is_in(options_.share, study_, run_of(study_, index)) ? 1U : 0U;
    }

private:
    // a run is there when all its cells are
    void add_all_but(const std::vector<bool>& stored) {
        const std::size_t stride = stored.size() / study_.directions.size();
        const std::size_t cells = directions_per_run(study_);
        for (std::size_t first = 0; first < stored.size() / cells; ++first) {
            if (!is_in(options_.share, study_, first)) continue;
            bool is_there = true;
            for (std::size_t k = 0; k < cells; ++k)
                is_there = is_there && stored[first + k * stride];
            if (!is_there) agenda_.add(first);
            there_ += is_there ? cells : 0;
        }
        to_come_ = agenda_.left() * cells;
    }

    const Study& study_;
    const RunOptions& options_;
    Agenda agenda_;
    std::vector<int> marks_;  // of the known cells of a refined study; shape [cell]
    std::size_t there_ = 0;
    std::size_t to_come_ = 0;
    std::size_t since_ = 0;  // [1] cells that became known since the last look
};

std::vector<crew::Task> tasks_of(std::span<const std::size_t> runs) {
    std::vector<crew::Task> tasks(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k)
        tasks[k].number = runs[k];
    return tasks;
}

// a run gives the same place in one direction after the other
std::vector<IndexedCell> cells_of(const Study& study, std::span<const crew::Result> results) {
    const std::size_t stride = cell_count(study) / study.directions.size();
    std::vector<IndexedCell> cells;
    cells.reserve(results.size() * directions_per_run(study));
    for (const crew::Result& result : results) {
        std::size_t index = result.number;
        for (Cell& cell : unpacked_cells(result.bytes)) {
            cells.push_back({index, std::move(cell)});
            index += stride;
        }
    }
    return cells;
}

}  // namespace

RunReport run(const Study& study, CellKeeper& keeper, const RunOptions& options) {
    STRIDOR_EXPECT(options.cells_per_commit > 0);
    Plan plan(study, keeper, options);
    Ledger ledger(keeper, options);
    ledger.expect(plan.there(), plan.to_come());
    const auto report = [&](SweepEnding ending) {
        ledger.finish();
        return RunReport{ending, ledger.computed(), ledger.progress()};
    };
    if (plan.to_come() == 0) return report(SweepEnding::completed);

    const std::unique_ptr<crew::Crew> crew = options.crew(work_of(study), options.stop);
    const std::size_t enough = std::max<std::size_t>(options.cells_per_commit / directions_per_run(study), 1);
    Agenda& agenda = plan.agenda();
    for (;;) {
        if (const std::size_t most = crew->appetite(agenda.left()); most > 0) crew->give(tasks_of(agenda.next(most)));
        std::vector<IndexedCell> cells = cells_of(study, crew->take(enough, Clock::now() + tick));
        plan.note(cells);
        ledger.take(std::move(cells));
        const bool is_idle = crew->is_idle();
        if (is_idle && crew->has_stopped()) {
            // what has come since the last look may ask for more
            if (study.refine > 0) {
                plan.look();
                ledger.expect(plan.there(), plan.to_come());
            }
            break;
        }
        if (agenda.left() > 0) continue;
        if (plan.is_worth_a_look(is_idle)) {
            plan.look();
            if (options.round && agenda.left() > 0) ledger.end_round();
            ledger.expect(plan.there(), plan.to_come());
        }
        if (is_idle && agenda.left() == 0) break;
    }
    const bool was_stopped = ledger.progress().done < ledger.progress().total;
    // what was finished is kept before anybody hears of a failure
    const RunReport result = report(was_stopped ? SweepEnding::stopped : SweepEnding::completed);
    if (was_stopped) crew->rethrow();
    return result;
}

}  // namespace stridor::sweep
