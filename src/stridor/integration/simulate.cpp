#include "stridor/integration/simulate.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/imposed_motion.hpp"
#include "stridor/integration/initial_state.hpp"
#include "stridor/integration/taylor/taylor.hpp"
#include "stridor/model/case_structure.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/record/schedule.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace stridor::integration {

Cost cost(const parameters::Case& c) {
    const double fastest = model::natural_frequencies(model::structure_of(c), model::ContactState::separation).back();
    if (c.run.engine == parameters::Engine::exact)
        return {std::ceil(c.run.duration * fastest), std::numeric_limits<double>::infinity()};
    return {std::ceil(c.run.duration / c.run.step), stable_step(c.run.beta_2, fastest)};
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop) {
    Workspace workspace;
    return simulate(c, request, std::move(stop), workspace);
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace) {
    if (c.own_structure) {
        const model::Structure structure = model::structure_of(c);
        record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure),
                                  static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                                  model::interfaces_of(structure));
        const double velocity = ImposedMotion(c.drive, 1.0).at(0.0).velocity;
        return integrate_taylor(structure, c.drive, initial_state(c, structure, velocity), {c.run.early_ending},
                                std::move(recorder), std::move(stop));
    }
    const bool has_several = !c.further_joints.empty();
    record::Recorder recorder(record::schedule(c), request, model::dofs_of_system(c),
                              static_cast<int>(parameters::joint_count(c)));
    if (has_several) {
        const model::Structure structure = model::rubbing_system(c);
        const Start start{c.run.initial, c.run.perturbation};
        const double velocity = ImposedMotion(c.drive, 1.0).at(0.0).velocity;
        return integrate_taylor(structure, c.drive, initial_state(structure, start, velocity), {c.run.early_ending},
                                std::move(recorder), std::move(stop));
    }
    switch (c.run.engine) {
        case parameters::Engine::exact:
            return integrate_exact(model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation},
                                   {c.run.early_ending, workspace.instruction_set}, std::move(recorder),
                                   std::move(stop), workspace.flows);
        case parameters::Engine::beta_2:
            return integrate_beta_2(model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation},
                                    {c.run.step, c.run.beta_2}, std::move(recorder), std::move(stop));
    }
    return {};
}

}  // namespace stridor::integration
