#include "stridor/model/friction/coulomb.hpp"

namespace stridor::model {

double stick_limit(const Coulomb& law, Slip) {
    return law.static_coefficient;
}

double slip_ratio(const Coulomb& law, Slip way) {
    return way == Slip::forward ? -law.kinetic_coefficient : law.kinetic_coefficient;
}

}  // namespace stridor::model
