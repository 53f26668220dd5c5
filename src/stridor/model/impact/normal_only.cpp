#include "stridor/model/impact/normal_only.hpp"

namespace stridor::model {

Impulses impulses(const NormalOnly&, const ContactInertia& inertia, const FrictionLaw&, const Approach& approach) {
    return {-inertia.normal * approach.gap_velocity, 0.0, 0.0, false};
}

}  // namespace stridor::model
