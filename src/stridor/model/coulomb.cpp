#include "stridor/model/coulomb.hpp"

namespace stridor::model {

double stick_limit(const Coulomb& friction, double normal_force) {
    return normal_force > 0.0 ? friction.static_coefficient * normal_force : 0.0;
}

double slip_force(const Coulomb& friction, double normal_force, double slip_velocity) {
    if (normal_force <= 0.0 || slip_velocity == 0.0) return 0.0;
    const double limit = friction.kinetic_coefficient * normal_force;
    return slip_velocity > 0.0 ? -limit : limit;
}

}  // namespace stridor::model
