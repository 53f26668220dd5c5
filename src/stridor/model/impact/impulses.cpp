// P_n = -m_g g' (1 + e) - c P_t, and P_t changes x' by P_t / m_x: so P_t = -m_x w ends the slip.

#include "stridor/model/impact/impulses.hpp"

namespace stridor::model {

Impulses impulses_with_friction(const ContactInertia& inertia, const FrictionLaw& friction, const Approach& approach,
                                double restitution) {
    const double straight = -inertia.normal * approach.gap_velocity * (1.0 + restitution);
    const double stopping = -inertia.tangential * approach.slip_velocity;
    const double normal = straight - inertia.coupling * stopping;
    if (holds(friction, normal, stopping)) return {normal, stopping, restitution, true};
    const double ratio = slip_ratio(friction, slip_against(stopping));
    const double slipping = straight / (1.0 + ratio * inertia.coupling);
    return {slipping, ratio * slipping, restitution, false};
}

}  // namespace stridor::model
