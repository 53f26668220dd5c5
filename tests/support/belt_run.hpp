#pragma once

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/record/schedule.hpp"

namespace stridor::support {

/// A run of the mass on a belt, the structure with closed-form solutions.
struct BeltRun {
    model::Belt belt;
    parameters::Drive drive;
    double duration = 1.0;  // [s]
    integration::Start start;
    integration::Beta2 settings;
    record::Request request;
};

/// A drive of constant velocity [m/s].
inline parameters::Drive constant_drive(double velocity) {
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::constant;
    drive.velocity = velocity;
    return drive;
}

inline integration::Motion integrate(const BeltRun& run) {
    parameters::Case c;
    c.drive = constant_drive(1.0);  // one phase, whatever really drives the belt
    c.run.duration = c.run.window = run.duration;
    return integration::integrate_beta_2(model::mass_on_belt(run.belt), run.drive, run.start, run.settings,
                                         record::Recorder(record::schedule(c), run.request, 2));
}

}  // namespace stridor::support
