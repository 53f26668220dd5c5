#include "stridor/integration/simulate.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/record/schedule.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace stridor::integration {

Cost cost(const parameters::Case& c) {
    const double fastest = model::natural_frequencies(model::rubbing_system(c), model::ContactState::separation).back();
    if (c.run.engine == parameters::Engine::exact)
        return {std::ceil(c.run.duration * fastest), std::numeric_limits<double>::infinity()};
    return {std::ceil(c.run.duration / c.run.step), stable_step(c.run.beta_2, fastest)};
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop) {
    Workspace workspace;
    return simulate(c, request, std::move(stop), workspace);
}

Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace) {
    record::Recorder recorder(record::schedule(c), request, model::rubbing_system_dofs);
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
