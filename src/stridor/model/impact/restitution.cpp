#include "stridor/model/impact/restitution.hpp"

namespace stridor::model {

Impulses impulses(const Restitution& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach) {
    return impulses_with_friction(inertia, friction, approach, law.coefficient);
}

}  // namespace stridor::model
