#pragma once

#include "stridor/integration/initial_state.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>

namespace stridor::integration {

/// What a run by time steps is about.
struct TimeSteps {
    double step = 1e-6;  // [s] h
    parameters::Formulation formulation = parameters::Formulation::standard;
    double massless_above = 0.0;  // [Hz] `massless_structure`
};

/// Runs time steps (`integrate_moreau` or `integrate_massless`) at the step h, and once more at 2 h for its times in
/// each state alone (`ContactTally::coarser`): by how much shares change with the step is about their error at h. With
/// both formulations the result is that of the standard one, and the tallies of the other stand beside it
/// (`Motion::massless`).
///
/// As they do; a run at 2 h without a result takes that of h away, too.
Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
