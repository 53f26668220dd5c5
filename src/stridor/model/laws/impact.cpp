// P_n = -m_g g' (1 + e) - c P_t, and P_t changes x' by P_t / m_x: so P_t = -m_x w ends the slip.

#include "stridor/model/laws/impact.hpp"

namespace stridor::model {

namespace {

Impulses with_friction(const ContactInertia& inertia, const FrictionLaw& friction, const Approach& approach,
                       double restitution) {
    const double straight = -inertia.normal * approach.gap_velocity * (1.0 + restitution);
    const double stopping = -inertia.tangential * approach.slip_velocity;
    const double normal = straight - inertia.coupling * stopping;
    if (holds(friction, normal, stopping)) return {normal, stopping, restitution, true};
    const double ratio = slip_ratio(friction, slip_against(stopping), approach.slip_velocity);
    const double slipping = straight / (1.0 + ratio * inertia.coupling);
    return {slipping, ratio * slipping, restitution, false};
}

struct Answer {
    const ContactInertia& inertia;
    const FrictionLaw& friction;
    const Approach& approach;

    Impulses operator()(const Plastic&) const { return with_friction(inertia, friction, approach, 0.0); }
    Impulses operator()(const NormalOnly&) const { return {-inertia.normal * approach.gap_velocity, 0.0, 0.0, false}; }
    Impulses operator()(const Restitution& law) const {
        return with_friction(inertia, friction, approach, law.coefficient);
    }
};

}  // namespace

Impulses impulses(const ImpactLaw& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach) {
    return std::visit(Answer{inertia, friction, approach}, law);
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
