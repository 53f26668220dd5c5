#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::model {

/// Returns the structure of any case: the paper's joint on a plate, several joints (`rubbing_system`), or the user's
/// own.
///
/// An own structure is pressed in one of two ways. Either contact.preload is shared among its contacts, f0 = -sum of n
/// N0. Or a load and negative gaps press it, and `static_contact` finds the forces. Displacements are measured from
/// that rest: u = 0 there, and the gaps are those still open. Its vibration is that of the contacts' points. Throws
/// `Error` (input) if a load closes no contact, or if the stiffness does not hold the pressed structure.
Structure structure_of(const parameters::Case& c);

}  // namespace stridor::model
