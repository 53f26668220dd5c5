#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::model {

/// The structure of any case: the paper's joint on a plate, several (`rubbing_system`), or the user's own.
///
/// An own structure is pressed by contact.preload in the shares of its contacts, f0 = -sum of n N0, or by a load and
/// gaps that are negative, whose forces `static_contact` finds. Displacements are measured from that rest: there u = 0,
/// and the gaps are what is left open. Its vibration is that of its contacts' points. Throws `Error` (input) where a
/// load does not close any contact, or the stiffness does not hold what it presses.
Structure structure_of(const parameters::Case& c);

}  // namespace stridor::model
