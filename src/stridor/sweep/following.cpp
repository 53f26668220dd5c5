#include "stridor/sweep/following.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace stridor::sweep {

namespace {

using integration::EndState;
using parameters::Case;
using parameters::Direction;

void expect_followable(const Case& base, const analysis::ScanRange& over) {
    if (parameters::is_by_force(base.drive))
        base::refuse("a drive by force is not followed", "its ramp would begin anew with each value",
                     "Follow a motion over a surface that moves.");
    parameters::expect_joint_of(base, over.key);
    const parameters::Field* field = parameters::field_of(over.key);
    if (field == nullptr || !std::holds_alternative<parameters::Quantity>(field->kind))
        base::refuse(over.key + " is no quantity", "a motion is followed along a number", "");
    if (!parameters::belongs(base, over.key))
        base::refuse(over.key + " means nothing for this case", "", "Follow another quantity.");
    if (field->section == "run" || field->section == "verdict" || parameters::is_of_start(*field))
        base::refuse(over.key + " is none of the system", "a motion is followed while the system changes",
                     "Follow a quantity of joint, plate, contact, temperature or drive.");
    if (!(over.from < over.to) || over.points < 2 || over.points > analysis::most_scan_points)
        base::refuse("the values " + base::shortest(over.from) + " to " + base::shortest(over.to) + " do not rise",
                     "a motion is followed up, and then down", "Write the lower value first, and two points at least.");
    Case c = base;
    for (const double end : {over.from, over.to})
        parameters::set_quantity(c, over.key, end);
}

// the values of both ways, the last one once
std::vector<std::pair<FollowedWay, double>> values_of(const analysis::ScanRange& over) {
    std::vector<std::pair<FollowedWay, double>> values;
    const auto value = [&](int k) {
        return k + 1 == over.points ? over.to : over.from + (over.to - over.from) * k / (over.points - 1);
    };
    for (int k = 0; k < over.points; ++k)
        values.emplace_back(FollowedWay::up, value(k));
    for (int k = over.points - 2; k >= 0; --k)
        values.emplace_back(FollowedWay::down, value(k));
    return values;
}

// the state at the end; nothing for a run without a result
std::optional<EndState> end_of(const Case& c, const std::stop_token& stop) {
    try {
        integration::Ended ended = integration::run_to_end(c, nullptr, stop);
        if (integration::has_result(ended.outcome)) return std::move(ended.state);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::numerical) throw;
    }
    return std::nullopt;
}

[[noreturn]] void interrupt() {
    throw Error(ErrorKind::interrupted, {"the motion was not followed to its end", "it was interrupted", ""});
}

}  // namespace

Following follow(const Case& base, const analysis::ScanRange& over, const FollowingOptions& options) {
    expect_followable(base, over);
    Following following{base, over, parameters::judged_directions(base.drive), {}};
    const std::vector<std::pair<FollowedWay, double>> values = values_of(over);
    integration::Workspace workspace;
    Case last = base;               // whose run ended in `state`
    std::optional<EndState> state;  // nothing before the first good run
    for (const auto& [way, value] : values) {
        // the drive goes on from the phase that it had: that of the run before, whatever its frequency was
        Case c = state ? integration::begun_at(last, *state) : base;
        parameters::set_quantity(c, over.key, value);
        const std::optional<Attempt> run = attempt(c, {}, options.stop, workspace);
        if (!run || options.stop.stop_requested()) interrupt();
        FollowedRun followed{way, value, {}, state.has_value()};
        for (const Direction direction : following.directions)
            followed.cells.push_back(cell_of(c, direction, *run));
        following.runs.push_back(std::move(followed));
        if (run->status == Status::done)
            if (std::optional<EndState> next = end_of(c, options.stop)) {
                state = std::move(next);
                last = std::move(c);
            }
        if (options.stop.stop_requested()) interrupt();
        if (options.progress) options.progress(following.runs.size(), values.size());
    }
    return following;
}

std::vector<double> hysteresis(const Following& following, std::size_t direction) {
    std::vector<double> values;
    const auto points = static_cast<std::size_t>(following.over.points);
    for (std::size_t k = 0; k + 1 < points; ++k) {
        const Cell& up = following.runs[k].cells[direction];
        const Cell& down = following.runs[2 * points - 2 - k].cells[direction];
        if (!has_same_verdict(up, down)) values.push_back(following.runs[k].value);
    }
    return values;
}

}  // namespace stridor::sweep
