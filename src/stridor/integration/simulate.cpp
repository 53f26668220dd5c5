#include "stridor/integration/simulate.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/exact/flow.hpp"
#include "stridor/integration/proofs/sliding_growth.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/integration/steps/formulations.hpp"
#include "stridor/integration/steps/massless_structure.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

namespace stridor::integration {

namespace {

using parameters::Engine;

constexpr double same_time = 1e-9;  // [1] of a time: rounding of a sum of times

// what the contacts carry at rest, and whether they creep, belongs to what is known of them
void tell_contacts(const model::Structure& structure, std::vector<record::Tally>& phases) {
    for (record::Tally& phase : phases)
        for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
            const model::ContactPoint& contact = structure.contacts[k];
            phase.contacts[k].preload = contact.preload;
            phase.contacts[k].creeps = std::holds_alternative<model::Regularised>(contact.friction);
        }
}

// what is wanted of a run
struct Watch {
    parameters::Drive drive;
    record::Schedule schedule;
    const record::Request& request;
    Handover* handover = nullptr;
};

// the paper's joint alone
Motion run_joint(const parameters::Case& c, const model::Structure& structure, const Watch& watch, std::stop_token stop,
                 Workspace& workspace) {
    record::Recorder recorder(watch.schedule, watch.request, model::dofs_of(structure), 1);
    Start start{c.run.initial, c.run.perturbation};
    if (c.run.initial == parameters::Initial::given)
        start.given = initial_state(c, structure, ImposedMotion(watch.drive, 1.0).at(0.0).velocity);
    start.handover = watch.handover;
    if (parameters::engine_of(c) == Engine::beta_2) {
        const StepRun run = [&](double step, record::Recorder taker) {
            return integrate_beta_2(structure, watch.drive, start, {step, c.run.beta_2}, std::move(taker), stop);
        };
        return run_twice(run, c.run.step, structure, std::move(recorder));
    }
    if (!workspace.flows) workspace.flows = std::make_shared<SharedFlows>();
    return integrate_exact(structure, watch.drive, start, {c.run.early_ending, workspace.instruction_set},
                           std::move(recorder), std::move(stop), *workspace.flows);
}

// by the engines that take structures of any size with any number of contacts
Motion run_any_size(const parameters::Case& c, const model::Structure& structure, const Watch& watch,
                    const std::stop_token& stop) {
    record::Recorder recorder(watch.schedule, watch.request, model::dofs_of(structure),
                              static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                              model::interfaces_of(structure));
    const double velocity = ImposedMotion(watch.drive, 1.0).at(0.0).velocity;
    InitialState start = initial_state(c, structure, velocity);
    start.handover = watch.handover;
    if (parameters::engine_of(c) == Engine::moreau)
        return integrate_twice(structure, watch.drive, start, {c.run.step, c.run.formulation, c.run.massless_above},
                               std::move(recorder), stop);
    return integrate_taylor(structure, watch.drive, start, {c.run.early_ending}, std::move(recorder), stop);
}

}  // namespace

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop) {
    Workspace workspace;
    return simulate(c, request, std::move(stop), workspace);
}

namespace {

Watch watch_of(const parameters::Case& c, const record::Request& request, Handover* handover = nullptr) {
    return {parameters::drive_of_run(c), record::schedule(c), request, handover};
}

// by the engine that the case names
Motion run_by_engine(const parameters::Case& c, const model::Structure& structure, const Watch& watch,
                     std::stop_token stop, Workspace& workspace) {
    const bool has_any_size = parameters::has_named_contacts(c) || parameters::engine_of(c) == Engine::moreau ||
                              parameters::is_solved_by_series(c);
    return has_any_size ? run_any_size(c, structure, watch, stop)
                        : run_joint(c, structure, watch, std::move(stop), workspace);
}

// adds to a motion what follows from its structure
Motion told(const parameters::Case& c, const model::Structure& structure, Motion motion) {
    tell_contacts(structure, motion.record.phases);
    if (motion.massless) tell_contacts(structure, motion.massless->phases);
    if (!has_result(motion.outcome) || !parameters::is_steady(c.drive)) return motion;
    const SteadyRun run{.surface_velocity = parameters::velocity_profile(c.drive).velocity,
                        .end = c.run.duration,
                        .least_slip = c.verdict.quiet_slip};
    tell_growth(structure, run, motion.record.phases);
    if (motion.massless) tell_growth(structure, run, motion.massless->phases);
    return motion;
}

// an end state fits the case, and lies before its window
void expect_goes_on(const parameters::Case& c, const model::Structure& structure, const EndState& from) {
    const auto dofs = static_cast<std::size_t>(model::dofs_of(structure));
    if (from.displacement.size() != dofs || from.contacts.size() != structure.contacts.size())
        base::refuse("the end state is none of this case",
                     "it has " + std::to_string(from.displacement.size()) + " degrees of freedom and " +
                         std::to_string(from.contacts.size()) + " contacts, the case " + std::to_string(dofs) +
                         " and " + std::to_string(structure.contacts.size()),
                     "Make it anew with --end-state.");
    const std::string time = base::shortest(from.time);
    if (!(c.run.duration > from.time))
        base::refuse("run.duration = " + base::shortest(c.run.duration) + " s is not beyond the end state",
                     "that is at " + time + " s, and the duration counts from the run's begin", "Make it longer.");
    if (c.run.duration - c.run.window < from.time * (1.0 - same_time))
        base::refuse("the window begins before the end state", "nothing is known of the time before " + time + " s",
                     "Give run.window at most " + base::shortest(c.run.duration - from.time) + " s.");
}

}  // namespace

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace) {
    const model::Structure structure = model::structure_of(c);
    return told(c, structure, run_by_engine(c, structure, watch_of(c, request), std::move(stop), workspace));
}

Motion go_on(const parameters::Case& c, const EndState& from, const record::Request& request, std::stop_token stop) {
    const model::Structure structure = model::structure_of(c);
    expect_goes_on(c, structure, from);
    record::Request later = request;
    later.trace.from = std::max(later.trace.from, from.time);
    Handover handover{&from};
    Workspace workspace;
    return told(c, structure, run_by_engine(c, structure, watch_of(c, later, &handover), std::move(stop), workspace));
}

Ended run_to_end(const parameters::Case& c, const EndState* from, std::stop_token stop) {
    // nothing is judged, so that a run which goes on has the same spans up to here
    parameters::Case unseen = c;
    unseen.run.window = 0.0;
    const model::Structure structure = model::structure_of(c);
    if (from != nullptr) expect_goes_on(unseen, structure, *from);
    Handover handover{from};
    Workspace workspace;
    const record::Request nothing;
    const Motion motion = run_by_engine(c, structure, watch_of(unseen, nothing, &handover), std::move(stop), workspace);
    handover.to.time = c.run.duration;
    return {motion.outcome, std::move(handover.to)};
}

}  // namespace stridor::integration
