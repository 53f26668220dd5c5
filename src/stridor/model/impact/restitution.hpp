#pragma once

#include "stridor/model/impact/impulses.hpp"

namespace stridor::model {

/// Newton's law: the surfaces part with a share of the velocity at which they met;
/// the tangential impulse as in `Plastic`.
struct Restitution {
    double coefficient = 0.0;  // [1] e, in [0, 1)

    bool operator==(const Restitution&) const = default;
};

/// As every law of impacts: see `impact/law.hpp`.
Impulses impulses(const Restitution& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

}  // namespace stridor::model
