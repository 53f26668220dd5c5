#pragma once

#include "stridor/integration/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/recorder.hpp"

#include <functional>

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

}  // namespace stridor::integration
