#include "stridor/integration/rules/set_search.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

double limit_of(const model::FrictionLaw& law, model::Slip way, StickLimit limit, double grown) {
    return limit == StickLimit::fallen ? std::abs(slip_ratio(law, way)) : stick_limit(law, way) + grown;
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
        const double limit = limit_of(law.friction, way, contact.limit, contact.grown);
        look(std::abs(contact.tangential) - limit * contact.normal, scale.push, slip_mode(way));
    } else {
        const double sign = sign_of(contact.mode);
        look(-sign * contact.slip_velocity, scale.speed, ContactMode::stick);
    }
    return worst;
}

std::vector<std::vector<ContactMode>> contact_sets(const std::vector<std::vector<ContactMode>>& possible,
                                                   const std::vector<ContactMode>& present, std::size_t most) {
    std::size_t count = 1;
    for (const std::vector<ContactMode>& each : possible) {
        count *= each.size();
        if (count == 0 || count > most) return {};
    }
    std::vector<std::vector<ContactMode>> sets(count, std::vector<ContactMode>(possible.size()));
    for (std::size_t number = 0; number < count; ++number) {
        std::size_t rest = number;
        for (std::size_t k = possible.size(); k-- > 0;) {
            sets[number][k] = possible[k][rest % possible[k].size()];
            rest /= possible[k].size();
        }
    }
    const auto changes = [&](const std::vector<ContactMode>& set) {
        std::size_t sum = 0;
        for (std::size_t k = 0; k < set.size(); ++k)
            sum += set[k] == present[k] ? 0U : 1U;
        return sum;
    };
    std::stable_sort(sets.begin(), sets.end(), [&](const auto& a, const auto& b) { return changes(a) < changes(b); });
    return sets;
}

}  // namespace stridor::integration
