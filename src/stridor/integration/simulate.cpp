#include "stridor/integration/simulate.hpp"

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
#include "stridor/model/case_structure.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/parameters/engines.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/record/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

namespace stridor::integration {

namespace {

using parameters::Engine;

// what the contacts carry at rest belongs to what is known of them
void tell_preloads(const model::Structure& structure, std::vector<record::Tally>& phases) {
    for (record::Tally& phase : phases)
        for (std::size_t k = 0; k < structure.contacts.size(); ++k)
            phase.contacts[k].preload = structure.contacts[k].preload;
}

// the paper's joint alone
Motion run_joint(const parameters::Case& c, const model::Structure& structure, const record::Request& request,
                 std::stop_token stop, Workspace& workspace) {
    record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure), 1);
    const Start start{c.run.initial, c.run.perturbation};
    if (c.run.engine == Engine::beta_2) {
        const StepRun run = [&](double step, record::Recorder taker) {
            return integrate_beta_2(structure, c.drive, start, {step, c.run.beta_2}, std::move(taker), stop);
        };
        return run_twice(run, c.run.step, structure, std::move(recorder));
    }
    if (!workspace.flows) workspace.flows = std::make_shared<SharedFlows>();
    return integrate_exact(structure, c.drive, start, {c.run.early_ending, workspace.instruction_set},
                           std::move(recorder), std::move(stop), *workspace.flows);
}

// by the engines that take structures of any size with any number of contacts
Motion run_any_size(const parameters::Case& c, const model::Structure& structure, const record::Request& request,
                    const std::stop_token& stop) {
    record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure),
                              static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                              model::interfaces_of(structure));
    const double velocity = ImposedMotion(c.drive, 1.0).at(0.0).velocity;
    const InitialState start = initial_state(c, structure, velocity);
    if (c.run.engine == Engine::moreau)
        return integrate_twice(structure, c.drive, start, {c.run.step, c.run.formulation, c.run.massless_above},
                               std::move(recorder), stop);
    return integrate_taylor(structure, c.drive, start, {c.run.early_ending}, std::move(recorder), stop);
}

}  // namespace

Cost cost(const parameters::Case& c) {
    const double steps = std::ceil(1.5 * c.run.duration / c.run.step);  // at the step and at twice the step
    const auto limit_without_inertia = [&] {
        return longest_step(massless_structure(model::structure_of(c), c.run.massless_above));
    };
    if (parameters::is_without_inertia(c)) return {steps, 0.5 * limit_without_inertia()};
    const double fastest = model::natural_frequencies(model::structure_of(c), model::ContactState::separation).back();
    if (c.run.engine == Engine::exact)
        return {std::ceil(c.run.duration * fastest), std::numeric_limits<double>::infinity()};
    double limit = c.run.engine == Engine::moreau ? std::numbers::pi / fastest : stable_step(c.run.beta_2, fastest);
    const std::size_t formulations = parameters::methods_of(c).size();
    if (formulations > 1) limit = std::min(limit, limit_without_inertia());
    return {steps * static_cast<double>(formulations), 0.5 * limit};
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop) {
    Workspace workspace;
    return simulate(c, request, std::move(stop), workspace);
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace) {
    const model::Structure structure = model::structure_of(c);
    const bool has_any_size =
        parameters::has_named_contacts(c) || c.run.engine == Engine::moreau || parameters::is_solved_by_series(c);
    Motion motion = has_any_size ? run_any_size(c, structure, request, stop)
                                 : run_joint(c, structure, request, std::move(stop), workspace);
    tell_preloads(structure, motion.record.phases);
    if (motion.massless) tell_preloads(structure, motion.massless->phases);
    if (!has_result(motion.outcome) || !parameters::is_steady(c.drive)) return motion;
    const SteadyRun run{.surface_velocity = parameters::velocity_profile(c.drive).velocity,
                        .end = c.run.duration,
                        .least_slip = c.verdict.quiet_slip};
    tell_growth(structure, run, motion.record.phases);
    if (motion.massless) tell_growth(structure, run, motion.massless->phases);
    return motion;
}

}  // namespace stridor::integration
