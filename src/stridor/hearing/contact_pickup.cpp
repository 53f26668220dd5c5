#include "stridor/hearing/contact_pickup.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/own_structure.hpp"

namespace stridor::hearing {

sound::Pickup contact_pickup(const parameters::Case& c, std::size_t contact, ContactDirection direction,
                             signal::MotionQuantity quantity) {
    STRIDOR_EXPECT(c.own_structure && contact < parameters::contact_count(c));
    const parameters::OwnContact& own = c.own_structure->contacts[contact];
    return {0, quantity, direction == ContactDirection::tangent ? own.tangent : own.normal};
}

}  // namespace stridor::hearing
