#pragma once

#include "stridor/integration/kernels/instruction_set.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>

namespace stridor::integration {

struct SharedFlows;

/// Settings of the exact engine.
struct Exact {
    parameters::EarlyEnding early_ending = parameters::EarlyEnding::proven;
    InstructionSet instruction_set = widest_instruction_set();  // changes the speed, never a bit
};

/// Solves the motion of a structure with a contact from event to event, without time-discretisation error.
///
/// Within a contact state the motion is the exponential of a matrix; the instants at which the state ends are roots of
/// linear functionals of it, found with certainty and to rounding. See docs/methods/exact.md.
///
/// Under a constant drive and without a trace a run ends early, as `settled`, once silence is proven or a limit
/// cycle found, unless the settings say never; the record is filled to the end all the same. The energy balance is
/// that of the time until then. `shared` keeps what was prepared for the next run. Returns `diverged` with the time
/// where a number left double precision, `chattering` where events pile up without time going on, `cancelled` soon
/// after a stop request.
///
/// It solves structures with two or three degrees of freedom and one contact with any law of friction and of impacts in
/// `model`. Throws `Error`: input for any other, by name; numerical for a Painleve configuration; what `initial_state`
/// throws.
Motion integrate_exact(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop, SharedFlows& shared);
/// Integrates one run that shares nothing.
Motion integrate_exact(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop = {});

}  // namespace stridor::integration
