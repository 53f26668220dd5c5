#include "stridor/integration/contact_sets/contact_violation.hpp"

#include "stridor/integration/contact_mode_of.hpp"

#include <cmath>

namespace stridor::integration {

ContactViolation violation(const ModalContact& law, const TriedContact& contact, const TrialScale& scale) {
    ContactViolation worst;
    const auto look = [&](double excess, double largest, ContactMode mode) {
        const double size = excess / largest;
        if (size > scale.rounding && size > worst.size) worst = {size, mode};
    };
    if (contact.mode == ContactMode::open) {
        look(-contact.gap_velocity, scale.speed, ContactMode::stick);
        return worst;
    }
    look(-contact.normal, scale.push, ContactMode::open);
    if (contact.mode == ContactMode::stick) {
        const model::Slip way = model::slip_against(contact.tangential);
        const double limit =
            contact.limit == StickLimit::fallen ? std::abs(law.ratio[index_of(way)]) : law.limit[index_of(way)];
        look(std::abs(contact.tangential) - limit * contact.normal, scale.push, slip_mode(way));
    } else {
        const double sign = contact.mode == ContactMode::slip_forward ? 1.0 : -1.0;
        look(-sign * contact.slip_velocity, scale.speed, ContactMode::stick);
    }
    return worst;
}

}  // namespace stridor::integration
