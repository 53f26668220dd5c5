#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/sound/auralisation.hpp"

#include <cstddef>

namespace stridor::hearing {

/// A direction of a contact: along the surface, or across it.
enum class ContactDirection { tangent, normal };

/// The point of a contact of the case's own structure, whose motion t.u or n.u is listened to: where two parts rub on
/// each other, that of one against the other.
sound::Pickup contact_pickup(const parameters::Case& c, std::size_t contact, ContactDirection direction,
                             signal::MotionQuantity quantity);

}  // namespace stridor::hearing
