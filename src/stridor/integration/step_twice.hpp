#pragma once

#include "stridor/integration/initial_state.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <functional>
#include <stop_token>

namespace stridor::integration {

/// Makes a run by time steps of so many seconds [s], into a recorder.
using StepRun = std::function<Motion(double step, record::Recorder recorder)>;

/// Returns a recorder of the same run that keeps tallies alone.
record::Recorder tallies_of(const record::Recorder& recorder, const model::Structure& structure);

/// Returns the run at the step h, with the tallies of the same at 2 h beside its own (`ContactTally::coarser`): by how
/// much figures change with the step is about their error at h.
///
/// A run at 2 h without a result takes that of h away, too.
Motion run_twice(const StepRun& run, double step, const model::Structure& structure, record::Recorder recorder);

/// What a run by time steps of many contacts is about.
struct TimeSteps {
    double step = 1e-6;  // [s] h
    parameters::Formulation formulation = parameters::Formulation::standard;
    double massless_above = 0.0;  // [Hz] `massless_structure`
};

/// Runs time steps (`integrate_moreau` or `integrate_massless`) at the step h, and once more at 2 h. With both
/// formulations the result is that of the standard one, and the tallies of the other, run twice as well, stand beside it
/// (`Motion::massless`).
Motion integrate_twice(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                       const TimeSteps& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
