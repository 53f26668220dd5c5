#include "stridor/sweep/diagram.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/results_version.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;

constexpr double finest_interval = 20e-6;  // [s] 30 samples a period of 1.6 kHz: extremes to half a percent
constexpr double most_samples = 2e5;       // [1] of a run

// the judged spans of one direction; a constant drive has one phase only
std::vector<record::Span> judged_spans(const Case& c, Direction direction) {
    const record::Phase wanted = direction == Direction::going ? record::Phase::going : record::Phase::coming;
    std::vector<record::Span> spans;
    for (const record::Span& span : record::schedule(c).spans)
        if (record::is_judged(span.use) && (span.phase == wanted || span.phase == record::Phase::all))
            spans.push_back(span);
    return spans;
}

// finds the local extremes of samples that come one after the other
class Extremes {
public:
    explicit Extremes(std::vector<record::Span> spans) : spans_(std::move(spans)) {}

    void add(double time, double value) {
        while (span_ < spans_.size() && time > spans_[span_].to) {
            ++span_;
            known_ = 0;
        }
        if (span_ == spans_.size() || time < spans_[span_].from) return;
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
        const bool turns = known_ >= 2 && (last_ - before_) * (value - last_) < 0.0;
        if (turns) values_.push_back(last_);
        before_ = last_;
        last_ = value;
        ++known_;
    }

    // the ends of the range where the motion never turns
    std::vector<double> take() {
        if (values_.empty() && low_ <= high_) values_ = {low_, high_};
        return std::move(values_);
    }

private:
    std::vector<record::Span> spans_;
    std::size_t span_ = 0;
    std::size_t known_ = 0;  // [1] samples in this span, before_ and last_ the latest of them
    double before_ = 0.0;
    double last_ = 0.0;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
    std::vector<double> values_;
};

// rising, without those that nobody could tell from their neighbour
std::vector<double> told_apart(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    if (values.empty()) return values;
    const double step = diagram_resolution * (values.back() - values.front());
    std::vector<double> kept{values.front()};
    for (const double value : values)
        if (value - kept.back() > step) kept.push_back(value);
    if (kept.back() != values.back()) kept.push_back(values.back());
    return kept;
}

// the times between like beats of each contact; a NaN parts those of different spans
std::vector<double> beat_intervals(const record::Tally& tally) {
    std::vector<double> intervals;
    for (const record::ContactTally& contact : tally.contacts) {
        const analysis::Alternation alternation = analysis::alternation(contact.changes);
        if (alternation.intervals == 0) continue;
        const std::vector<double>& times = contact.changes[record::change_kind(alternation.from, alternation.to)].times;
        for (std::size_t k = 1; k < times.size(); ++k)
            if (const double interval = times[k] - times[k - 1]; std::isfinite(interval)) intervals.push_back(interval);
    }
    return intervals;
}

// nothing if it was stopped
std::optional<DiagramCell> cell_at(const Study& study, const CellPlace& place, const std::stop_token& stop,
                                   integration::Workspace& workspace) {
    const Case c = case_at(study, place);
    const Direction direction = study.directions[place.direction];
    // an invalid case has no schedule
    if (!parameters::findings(c).empty()) return DiagramCell{};
    const std::vector<record::Span> spans = judged_spans(c, direction);
    if (spans.empty()) return DiagramCell{};
    Extremes extremes(spans);
    record::Request request;
    request.trace.from = spans.front().from;
    request.trace.to = spans.back().to;
    request.trace.interval = std::max(finest_interval, (request.trace.to - request.trace.from) / most_samples);
    request.trace.taker = [&](const record::Trace& trace) {
        for (std::size_t k = 0; k < trace.time.size(); ++k)
            extremes.add(trace.time[k], trace.displacement.front()[k]);
    };
    const std::optional<Attempt> run = attempt(c, request, stop, workspace);
    if (!run) return std::nullopt;
    if (run->status != Status::done) return DiagramCell{};
    DiagramCell cell{told_apart(extremes.take()), {}};
    const record::Phase wanted = direction == Direction::going ? record::Phase::going : record::Phase::coming;
    for (const record::Tally& tally : run->motion.record.phases)
        if (tally.phase == wanted || tally.phase == record::Phase::all)
            cell.intervals = told_apart(beat_intervals(tally));
    return cell;
}

std::vector<double> numbers_in(base::Unpacking& unpacking) {
    const std::uint64_t count = unpacking.count();
    std::vector<double> values;
    for (std::uint64_t k = 0; k < count && unpacking.is_good(); ++k)
        values.push_back(unpacking.number());
    return values;
}

// the start that a task says
std::string bytes_of(std::size_t start) {
    base::Packing packing;
    packing.add(static_cast<std::uint64_t>(start));
    return packing.take();
}

}  // namespace

crew::Work diagram_work(const Study& study) {
    const auto compute = [&study](const crew::Task& task, const std::stop_token& stop,
                                  integration::Workspace& workspace) -> std::optional<std::string> {
        CellPlace place = place_of(study, task.number);
        place.start = base::Unpacking(task.bytes).count();
        const std::optional<DiagramCell> cell = cell_at(study, place, stop, workspace);
        return cell ? std::optional(packed(*cell)) : std::nullopt;
    };
    return simulating_work(diagram_text(study), compute);
}

std::vector<DiagramCell> diagram(const SweepResult& result, const DiagramOptions& options) {
    STRIDOR_EXPECT(has_one_axis(result.study));
    std::vector<DiagramCell> cells(result.cells.size());
    std::vector<crew::Task> tasks;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        // a joint that is carried along has no motion of its own
        const classification::Quiet quiet = result.cells[index].quiet;
        if (quiet == classification::Quiet::sticks || quiet == classification::Quiet::locks) continue;
        const std::optional<std::string> text = options.kept == nullptr ? std::nullopt : options.kept->find(index);
        if (std::optional<DiagramCell> kept = text ? unpacked_diagram_cell(*text) : std::nullopt)
            cells[index] = std::move(*kept);
        else
            tasks.push_back({index, bytes_of(shown_place(result, index).start)});
    }
    std::size_t done = cells.size() - tasks.size();
    const auto take = [&](crew::Result computed) {
        std::optional<DiagramCell> cell = unpacked_diagram_cell(computed.bytes);
        if (!cell) throw crew::damaged_result();
        cells[computed.number] = std::move(*cell);
        if (options.kept != nullptr) options.kept->keep(computed.number, std::move(computed.bytes));
        ++done;
    };
    const auto tick = [&] {
        if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(cells.size()));
    };
    const std::unique_ptr<crew::Crew> crew = options.crew(diagram_work(result.study), options.stop);
    crew::compute(*crew, std::move(tasks), take, tick);
    if (done < cells.size())
        throw Error(ErrorKind::interrupted,
                    {"stopped while drawing the diagram", "what is computed is kept", "Run the same command again."});
    return cells;
}

std::string diagram_text(const Study& study) {
    return "diagram\n" + canonical_text(study) + "results = " + std::to_string(results_version) + "\n";
}

std::string packed(const DiagramCell& cell) {
    base::Packing packing;
    for (const std::vector<double>* values : {&cell.extremes, &cell.intervals}) {
        packing.add(static_cast<std::uint64_t>(values->size()));
        for (const double value : *values)
            packing.add(value);
    }
    return packing.take();
}

std::optional<DiagramCell> unpacked_diagram_cell(std::string_view text) {
    base::Unpacking unpacking(text);
    DiagramCell cell;
    cell.extremes = numbers_in(unpacking);
    cell.intervals = numbers_in(unpacking);
    return unpacking.is_complete() ? std::optional(std::move(cell)) : std::nullopt;
}

}  // namespace stridor::sweep
