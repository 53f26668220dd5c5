#include "stridor/model/impact/plastic.hpp"

namespace stridor::model {

Impulses impulses(const Plastic&, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach) {
    return impulses_with_friction(inertia, friction, approach, 0.0);
}

}  // namespace stridor::model
