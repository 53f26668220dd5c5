#include "stridor/integration/simulate.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/imposed_motion.hpp"
#include "stridor/integration/initial_state.hpp"
#include "stridor/integration/massless/massless_structure.hpp"
#include "stridor/integration/moreau/moreau_twice.hpp"
#include "stridor/integration/taylor/taylor.hpp"
#include "stridor/model/case_structure.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/record/schedule.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace stridor::integration {

namespace {

// by the engines that take structures of any size with any number of contacts
Motion simulate_any_size(const parameters::Case& c, const record::Request& request, const std::stop_token& stop) {
    const model::Structure structure = model::structure_of(c);
    record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure),
                              static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                              model::interfaces_of(structure));
    const double velocity = ImposedMotion(c.drive, 1.0).at(0.0).velocity;
    const InitialState start = initial_state(c, structure, velocity);
    if (c.run.engine == parameters::Engine::moreau)
        return integrate_twice(structure, c.drive, start, {c.run.step, c.run.formulation, c.run.massless_above},
                               std::move(recorder), stop);
    return integrate_taylor(structure, c.drive, start, {c.run.early_ending}, std::move(recorder), stop);
}

}  // namespace

Cost cost(const parameters::Case& c) {
    if (parameters::is_without_inertia(c))
        return {std::ceil(1.5 * c.run.duration / c.run.step),
                0.5 * longest_step(massless_structure(model::structure_of(c), c.run.massless_above))};
    const double fastest = model::natural_frequencies(model::structure_of(c), model::ContactState::separation).back();
    if (c.run.engine == parameters::Engine::exact)
        return {std::ceil(c.run.duration * fastest), std::numeric_limits<double>::infinity()};
    if (c.run.engine == parameters::Engine::moreau)  // at the step and at twice the step
        return {std::ceil(1.5 * c.run.duration / c.run.step), 0.5 * std::numbers::pi / fastest};
    return {std::ceil(c.run.duration / c.run.step), stable_step(c.run.beta_2, fastest)};
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop) {
    Workspace workspace;
    return simulate(c, request, std::move(stop), workspace);
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace) {
    if (c.own_structure || !c.further_joints.empty() || c.run.engine == parameters::Engine::moreau)
        return simulate_any_size(c, request, stop);
    record::Recorder recorder(record::schedule(c), request, model::dofs_of_system(c), 1);
    switch (c.run.engine) {
        case parameters::Engine::exact:
            return integrate_exact(model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation},
                                   {c.run.early_ending, workspace.instruction_set}, std::move(recorder),
                                   std::move(stop), workspace.flows);
        case parameters::Engine::beta_2:
            return integrate_beta_2(model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation},
                                    {c.run.step, c.run.beta_2}, std::move(recorder), stop);
        case parameters::Engine::moreau:
            break;  // above
    }
    return {};
}

}  // namespace stridor::integration
