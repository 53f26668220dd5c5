#include "stridor/model/impact/law.hpp"

namespace stridor::model {

Impulses impulses(const ImpactLaw& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach) {
    return std::visit([&](const auto& each) { return impulses(each, inertia, friction, approach); }, law);
}

ImpactLaw impact_law(const parameters::Contact& contact) {
    switch (contact.impact) {
        case parameters::ImpactLaw::plastic:
            return Plastic{};
        case parameters::ImpactLaw::normal_only:
            return NormalOnly{};
        case parameters::ImpactLaw::restitution:
            return Restitution{contact.restitution};
    }
    return Plastic{};
}

}  // namespace stridor::model
