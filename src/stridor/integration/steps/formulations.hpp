#pragma once

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <stop_token>

namespace stridor::integration {

/// What a run by time steps of many contacts is about.
struct TimeSteps {
    double step = 1e-6;  // [s] h
    parameters::Formulation formulation = parameters::Formulation::standard;
    double massless_above = 0.0;  // [Hz] `massless_structure`
};

/// Runs time steps (`integrate_moreau` or `integrate_massless`) at the step h, and once more at 2 h. With both
/// formulations the result is that of the standard one, and the tallies of the other, run twice as well, stand beside
/// it (`Motion::massless`).
Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
