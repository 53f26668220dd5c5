#pragma once

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/integration/steps/massless_structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>

namespace stridor::integration {

/// Settings of the time stepping without inertia at the contacts.
struct Massless {
    double step = 1e-6;  // [s] h
    double above = 0.0;  // [Hz] `massless_structure`
};

/// Solves the motion of a structure whose contacts move without inertia (`MasslessStructure`), by time steps:
///
///     q, v     the free structure's exact motion under the load, pushed by half a step of contact forces before and
///              after it (leapfrog)
///     place    = R q + G lambda at the step's end, with lambda so that gaps and slips of the step obey the laws of
///              contact, all at once (`StepContacts`)
///
/// Contact is a matter of places: a closed gap is zero, none bounces, and no law of impact is asked for. Its forces
/// are as good as the modes that are left: their flexibility is the contact's own stiffness. Second order where no
/// contact changes its state. Returns `no_forces`, `diverged`, `step_limit` beyond `longest_step`, `cancelled`. Throws
/// `Error` (input) as `massless_structure` and `expect_solvable`.
Motion integrate_massless(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                          const Massless& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
