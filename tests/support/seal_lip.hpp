#pragma once

#include "stridor/parameters/case.hpp"

namespace stridor::support {

/// The lip of a door seal: soft, and self-locking while going. It slips once for 28 us and then sticks for ever.
inline parameters::Case seal_lip() {
    parameters::Case c;
    c.joint() = {0.004, 25e3, 1.5e3, 1.5, 0.4, 60.0};
    c.plate = {0.35, 400e3, 5.0};
    c.contact().preload = 8.0;
    c.contact().static_friction = 1.2;
    c.contact().kinetic_friction = 0.9;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.05;
    return c;
}

}  // namespace stridor::support
