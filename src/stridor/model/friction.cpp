#include "stridor/model/friction.hpp"

#include <cmath>

namespace stridor::model {

bool holds(const FrictionLaw& law, double normal_force, double friction_force) {
    return normal_force >= 0.0 &&
           std::abs(friction_force) <= stick_limit(law, slip_against(friction_force)) * normal_force;
}

FrictionLaw friction_law(const parameters::Contact& contact) {
    switch (contact.friction) {
        case parameters::FrictionKind::coulomb:
            return Coulomb{contact.static_friction, contact.kinetic_friction};
        case parameters::FrictionKind::directional:  // a plate that goes drags the joint, which slips backward
            return Directional{{contact.static_friction_coming, contact.static_friction},
                               {contact.kinetic_friction_coming, contact.kinetic_friction}};
        case parameters::FrictionKind::linear:
            return Linear{contact.static_friction, contact.kinetic_friction, contact.friction_slope};
    }
    return {};
}

}  // namespace stridor::model
