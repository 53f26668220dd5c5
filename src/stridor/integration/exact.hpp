#pragma once

#include "stridor/integration/exact_flow.hpp"
#include "stridor/integration/exact_kernel.hpp"
#include "stridor/integration/initial_state.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>
#include <utility>

namespace stridor::integration {

/// Settings of the exact engine.
struct Exact {
    parameters::ImpactLaw impact = parameters::ImpactLaw::plastic;
    double restitution = 0.0;  // [1] restitution law only: rebound velocity over impact velocity
    parameters::EarlyEnding early_ending = parameters::EarlyEnding::proven;
    InstructionSet instruction_set = widest_instruction_set();  // changes the speed, never a bit
};

/// Solves the motion of a structure with a contact from event to event, without time-discretisation error.
///
/// Within a contact state the motion is the exponential of a matrix; the instants at which the state ends are roots of
/// linear functionals of it, found with certainty and to rounding. See docs/methods/exact.md.
///
/// Under a constant drive and without a trace a run ends early, as `settled`, once silence is proven or a limit cycle found,
/// unless the settings say never; the record is filled to the end all the same. The energy balance is that of the time
/// until then. `shared` keeps what was prepared for the next run. Returns `diverged` with the
/// time where a number left double precision, `chattering` where events pile up without time going on, `cancelled` soon
/// after a stop request. Throws `Error` (numerical) for a Painleve configuration and what `initial_state` throws.
template <int dofs>
Motion integrate_exact(const model::Structure<dofs>& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop,
                       SharedFlows<dofs>& shared);

template <int dofs>
Motion integrate_exact(const model::Structure<dofs>& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop = {}) {
    SharedFlows<dofs> own;
    return integrate_exact(structure, drive, start, settings, std::move(recorder), std::move(stop), own);
}

extern template Motion integrate_exact<2>(const model::Structure<2>&, const parameters::Drive&, const Start&,
                                          const Exact&, record::Recorder, std::stop_token, SharedFlows<2>&);
extern template Motion integrate_exact<3>(const model::Structure<3>&, const parameters::Drive&, const Start&,
                                          const Exact&, record::Recorder, std::stop_token, SharedFlows<3>&);

}  // namespace stridor::integration
