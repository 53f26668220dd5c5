#pragma once

#include "stridor/model/friction/slip.hpp"

namespace stridor::model {

/// Coulomb friction with two coefficients, the same both ways and independent of the slip velocity (Elmaian et al.
/// 2012, Figure 3):
///
///     stick  |T| <= mu_s N        slip  T = -sign(w) mu_d N
struct Coulomb {
    double static_coefficient = 0.0;   // [1] mu_s
    double kinetic_coefficient = 0.0;  // [1] mu_d <= mu_s

    bool operator==(const Coulomb&) const = default;
};

/// As every law of friction: see `friction/law.hpp`.
double stick_limit(const Coulomb& law, Slip way);

/// Likewise.
double slip_ratio(const Coulomb& law, Slip way);

}  // namespace stridor::model
