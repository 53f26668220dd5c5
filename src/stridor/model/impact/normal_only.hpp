#pragma once

#include "stridor/model/impact/impulses.hpp"

namespace stridor::model {

/// No rebound and no tangential impulse.
struct NormalOnly {
    bool operator==(const NormalOnly&) const = default;
};

/// As every law of impacts: see `impact/law.hpp`.
Impulses impulses(const NormalOnly& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

}  // namespace stridor::model
