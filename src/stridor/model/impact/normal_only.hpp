#pragma once

#include "stridor/model/impact/impulses.hpp"

namespace stridor::model {

/// No rebound and no tangential impulse.
struct NormalOnly {
    bool operator==(const NormalOnly&) const = default;
};

Impulses impulses(const NormalOnly& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

}  // namespace stridor::model
