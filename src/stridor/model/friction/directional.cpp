#include "stridor/model/friction/directional.hpp"

namespace stridor::model {

double stick_limit(const Directional& law, Slip way) {
    return law.static_coefficients[index_of(way)];
}

double slip_ratio(const Directional& law, Slip way) {
    const double kinetic = law.kinetic_coefficients[index_of(way)];
    return way == Slip::forward ? -kinetic : kinetic;
}

}  // namespace stridor::model
