#include "stridor/model/impact/law.hpp"

namespace stridor::model {

Impulses impulses(const ImpactLaw& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach) {
    return std::visit([&](const auto& each) { return impulses(each, inertia, friction, approach); }, law);
}

ImpactLaw impact_law(const parameters::Contact& contact) {
    switch (contact.impact) {
        case parameters::ImpactKind::plastic:
            return Plastic{};
        case parameters::ImpactKind::normal_only:
            return NormalOnly{};
        case parameters::ImpactKind::restitution:
            return Restitution{contact.restitution};
    }
    return Plastic{};
}

}  // namespace stridor::model
