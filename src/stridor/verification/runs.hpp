#pragma once

#include "stridor/integration/motion.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

/// Runs that closed forms are held against.
namespace stridor::verification {

/// A drive of constant velocity [m/s].
parameters::Drive constant_drive(double velocity);

/// Records [from, to] [s] as one judged phase, and a trace on request.
record::Recorder whole_run(double from, double to, const record::TraceRequest& trace = {});

/// The mass on a belt, stuck at first under a constant drive, at rest under any other; beta_2 with 1e-6 s and 1/2.
integration::Motion run_belt(const model::Belt& belt, const parameters::Drive& drive, parameters::Engine engine,
                             record::Recorder recorder);

}  // namespace stridor::verification
