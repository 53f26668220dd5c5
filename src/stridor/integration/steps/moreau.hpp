#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>

namespace stridor::integration {

/// Settings of Moreau's time stepping.
struct Moreau {
    double step = 1e-6;  // [s] h
};

/// Returns the longest time step [s] for a structure: half a period of its fastest mode, beyond which a push would move
/// it the other way. Accuracy asks for far less.
double longest_step(const ModalStructure& structure);

/// Solves the motion of a structure with many contacts by time steps: the free structure moves exactly, and contact
/// forces are constant within a step.
///
/// A contact takes part in a step if it was closed before, or if its gap would be closed at the step's end. The forces
/// of a step make the laws of contact hold for the velocities at its end (Moreau 1988), all contacts at once
/// (`StepContacts`). Gaps that have closed are set to zero at right angles under the mass. States and shares are exact
/// to first order of the step: run it at half the step to see by how much they move. See docs/methods/moreau.md.
///
/// Costs: 4 n p operations a step and 4 p² per change of a contact's state. Returns `painleve` or `no_forces` with the
/// time where no states obey the laws, `diverged`, `step_limit` beyond `longest_step`, `cancelled` soon after a stop
/// request. Throws `Error` (input) as `expect_solvable` and for what `modal_structure` refuses.
Motion integrate_moreau(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Moreau& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
