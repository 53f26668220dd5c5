#pragma once

#include "stridor/parameters/case.hpp"
#include "support/property.hpp"

#include <cmath>

namespace stridor::support {

/// A rubbing system of any stiffness, friction and preload around Table 1's, moved at a constant velocity for 20 ms.
///
/// The incidence angle is a multiple of 1/16 degree, so that 180 - a is exact. The engine is left to the caller.
inline parameters::Case any_constant_case() {
    parameters::Case c;
    c.joint().mass = *number_between(0.05, 0.5);
    c.joint().axial_stiffness = std::pow(10.0, *number_between(6.0, 7.5));
    c.joint().flexural_stiffness = std::pow(10.0, *number_between(5.5, 7.0));
    c.joint().axial_damping = *number_between(0.0, 20.0);
    c.joint().flexural_damping = *number_between(0.0, 20.0);
    c.joint().incidence_angle = *whole_between(0, 180 * 16) / 16.0;
    c.plate.mass = *number_between(0.1, 1.0);
    c.plate.stiffness = std::pow(10.0, *number_between(5.5, 7.0));
    c.contact().preload = std::pow(10.0, *number_between(0.0, 3.3));
    c.contact().static_friction = *number_between(0.1, 1.5);
    c.contact().kinetic_friction = c.contact().static_friction * *number_between(0.1, 1.0);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = std::pow(10.0, *number_between(-3.0, 0.0)) * (*whole_between(0, 1) == 0 ? 1.0 : -1.0);
    c.run.initial = *whole_between(0, 1) == 0 ? parameters::Initial::rest : parameters::Initial::stuck;
    c.run.duration = c.run.window = 0.02;
    return c;
}

/// The same system under a sinusoidal drive fast enough to turn twice in the 20 ms.
inline parameters::Case any_sinusoidal_case() {
    parameters::Case c = any_constant_case();
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.frequency = *number_between(75.0, 150.0);
    c.drive.amplitude = std::pow(10.0, *number_between(-6.0, -3.0));
    return c;
}

}  // namespace stridor::support
