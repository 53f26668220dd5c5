#include "stridor/integration/contact_sets/contact_violation.hpp"

#include "stridor/integration/contact_mode_of.hpp"

#include <cmath>

namespace stridor::integration {

double limit_of(const model::FrictionLaw& law, model::Slip way, StickLimit limit) {
    return limit == StickLimit::fallen ? std::abs(slip_ratio(law, way)) : stick_limit(law, way);
}

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
        look(std::abs(contact.tangential) - limit_of(law.friction, way, contact.limit) * contact.normal, scale.push,
             slip_mode(way));
    } else {
        const double sign = contact.mode == ContactMode::slip_forward ? 1.0 : -1.0;
        look(-sign * contact.slip_velocity, scale.speed, ContactMode::stick);
    }
    return worst;
}

}  // namespace stridor::integration
