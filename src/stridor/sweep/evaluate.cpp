#include "stridor/sweep/evaluate.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace stridor::sweep {

namespace {

using integration::Motion;
using integration::Reason;
using parameters::Case;
using parameters::Direction;
using record::Phase;

// of a run without a result
Status status_of(Reason reason) {
    if (reason == Reason::step_limit) return Status::step_limit;
    return reason == Reason::diverged ? Status::diverged : Status::failed;
}

Attempt ended(Motion motion, const Case& c) {
    if (const std::optional<Error> failure = integration::failure(c, motion))
        return {status_of(motion.outcome.reason), failure->what(), {}};
    return {Status::done, "", std::move(motion)};
}

// the tally of one direction; an empty one if the drive never moves that way, which is judged undecided
record::Tally tally_of(const Case& c, const Motion& motion, Direction direction) {
    const Phase wanted = direction == Direction::going ? Phase::going : Phase::coming;
    for (const record::Tally& tally : motion.record.phases)
        if (tally.phase == wanted || tally.phase == Phase::all) return tally;
    record::Tally nothing;
    nothing.phase = wanted;
    nothing.contacts.resize(parameters::contact_count(c));
    nothing.vibration.resize(parameters::channel_count(c));
    nothing.closing_vibration.resize(parameters::channel_count(c));
    return nothing;
}

}  // namespace

bool can_begin(const Case& c) {
    if (c.run.initial != parameters::Initial::sliding || !parameters::findings(c).empty()) return true;
    try {
        integration::initial_state(c, model::structure_of(c),
                                   integration::ImposedMotion(c.drive, 1.0).at(0.0).velocity);
        return true;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::numerical) throw;
        return false;
    }
}

std::optional<Attempt> attempt(const Case& c, const record::Request& request, std::stop_token stop,
                               integration::Workspace& workspace) {
    const std::vector<parameters::Finding> findings = parameters::findings(c);
    if (!findings.empty())
        return Attempt{Status::invalid, Error(ErrorKind::input, findings.front().problem).what(), {}};
    try {
        Motion motion = integration::simulate(c, request, std::move(stop), workspace);
        if (motion.outcome.reason == Reason::cancelled) return std::nullopt;
        return ended(std::move(motion), c);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::numerical) return Attempt{Status::failed, error.what(), {}};
        // a load may close no contact of a structure whose stiffness is scaled
        if (error.kind() == ErrorKind::input && !parameters::has_plate(c))
            return Attempt{Status::invalid, error.what(), {}};
        throw;
    }
}

Cell cell_of(const Case& c, Direction direction, const Attempt& attempt) {
    Cell cell;
    cell.status = attempt.status;
    cell.message = attempt.message;
    if (attempt.status != Status::done) return cell;

    const classification::Verdict verdict = classification::classify_phase(tally_of(c, attempt.motion, direction),
                                                                           c.verdict, classification::contact_names(c));
    cell.category = verdict.category;
    cell.quiet = verdict.quiet;
    if (verdict.category == classification::Category::undecided) cell.message = verdict.reasons.back();
    cell.figures =
        figures_of({verdict.evidence,
                    analysis::sliding_stability(model::structure_of(c), direction, analysis::sliding_speed(c.drive)),
                    attempt.motion});
    return cell;
}

namespace {

// the cells of one run from one start, in the order of the directions; none if it was stopped
std::vector<Cell> evaluate_start(const Case& c, std::span<const Direction> directions, const std::stop_token& stop,
                                 integration::Workspace& workspace) {
    const std::optional<Attempt> run = attempt(c, {}, stop, workspace);
    if (!run) return {};
    std::vector<Cell> cells;
    for (const Direction direction : directions)
        cells.push_back(cell_of(c, direction, *run));
    return cells;
}

// which starts a case has; shape [start]
std::vector<bool> beginning(std::size_t starts, const std::function<Case(std::size_t start)>& case_of) {
    std::vector<bool> begins;
    for (std::size_t start = 0; start < starts; ++start)
        begins.push_back(can_begin(case_of(start)));
    return begins;
}

}  // namespace

std::vector<Cell> evaluate_starts(std::size_t starts, std::span<const Direction> directions,
                                  const std::function<Case(std::size_t start)>& case_of, const std::stop_token& stop,
                                  integration::Workspace& workspace) {
    if (starts == 0) return evaluate_start(case_of(0), directions, stop, workspace);
    const std::vector<bool> begins = beginning(starts, case_of);
    const std::size_t first = static_cast<std::size_t>(std::find(begins.begin(), begins.end(), true) - begins.begin());
    std::vector<Cell> of_first = evaluate_start(case_of(first < starts ? first : 0), directions, stop, workspace);
    if (of_first.empty()) return {};
    std::vector<std::vector<Cell>> by_start(directions.size());  // shape [direction][start]
    for (std::size_t start = 0; start < starts; ++start) {
        const bool is_own = begins[start] && start != first;
        std::vector<Cell> cells = is_own ? evaluate_start(case_of(start), directions, stop, workspace) : of_first;
        if (cells.empty()) return {};
        for (std::size_t direction = 0; direction < cells.size(); ++direction)
            by_start[direction].push_back(std::move(cells[direction]));
    }
    std::vector<Cell> cells;
    for (std::vector<Cell>& same_cell : by_start)
        cells.push_back(joined(std::move(same_cell)));
    return cells;
}

std::vector<Cell> evaluate_run(const Study& study, std::size_t first, const std::stop_token& stop,
                               integration::Workspace& workspace) {
    CellPlace place = place_of(study, first);
    const auto case_of = [&](std::size_t start) {
        place.start = start;
        return case_at(study, place);
    };
    return evaluate_starts(study.starts.size(),
                           std::span(study.directions).subspan(place.direction, directions_per_run(study)), case_of,
                           stop, workspace);
}

std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop) {
    integration::Workspace workspace;
    std::vector<Cell> cells;
    for (std::size_t first = 0; first < study.directions.size(); first += directions_per_run(study)) {
        std::vector<Cell> of_run = evaluate_run(study, index_of(study, {first, iy, ix}), stop, workspace);
        if (of_run.empty()) return {};
        std::move(of_run.begin(), of_run.end(), std::back_inserter(cells));
    }
    return cells;
}

}  // namespace stridor::sweep
