#pragma once

#include "stridor/parameters/paper_cases.hpp"

namespace stridor::support {

/// A column of Table 1 at a constant velocity [m/s], looked at from its start to its end [s].
inline parameters::Case constant_case(parameters::PaperCase which, double velocity, double duration) {
    parameters::Case c = parameters::paper_case(which);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = c.run.window = duration;
    return c;
}

/// The squeal column at 0.1 m/s for 20 ms, of which the second half is looked at.
inline parameters::Case short_case() {
    parameters::Case c = constant_case(parameters::PaperCase::squeal, 0.1, 0.02);
    c.run.window = 0.01;
    return c;
}

}  // namespace stridor::support
