#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <Eigen/Core>

namespace stridor::integration {

/// Returns what is known of a stick whose limit grows with rest, from what would be known if it did not. What holds
/// without growth holds with it. What ends by forces that rise evenly ends later: no such growth keeps up with them
/// unless N rises, too. Whether forces that swing, or stand still, end it is not known.
record::Outlook with_rest(record::Outlook outlook);

/// A stuck contact at one instant.
struct StuckState {
    Eigen::VectorXd displacement;       // [m] u, shape [dof]
    Eigen::VectorXd velocity;           // [m/s] u', shape [dof]
    double surface_velocity = 0.0;      // [m/s] V
    double surface_acceleration = 0.0;  // [m/s^2] V'
    double time = 0.0;                  // [s]
    double since = 0.0;                 // [s] when it began to stick
};

/// Says whether a contact that sticks now sticks for ever, if the drive goes on as it is.
///
/// `sticks` is proven by a bound on the energy of the vibration that is left, `releases` by the forces that the drive
/// itself builds up (derivation: sticking.cpp); `unknown` where that vibration may or may not end the stick, for a
/// sampled drive, and where a free motion has no stiffness or negative damping. A release under a constant drive comes
/// with its time, about. Whatever is known, it comes with how the normal force follows the way (`Drag`). Throws
/// `Error` (input) what `only_contact` refuses.
record::Outlook outlook_of_stick(const model::Structure& structure, const parameters::VelocityProfile& profile,
                                 const StuckState& now);

}  // namespace stridor::integration
