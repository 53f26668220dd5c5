#pragma once

#include "stridor/model/impact/impulses.hpp"

namespace stridor::model {

/// No rebound; the tangential impulse obeys the same friction cone as the forces.
/// What the beta_2 scheme does as h -> 0.
struct Plastic {
    bool operator==(const Plastic&) const = default;
};

/// As every law of impacts: see `impact/law.hpp`.
Impulses impulses(const Plastic& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

}  // namespace stridor::model
