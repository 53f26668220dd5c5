#pragma once

#include "stridor/model/friction/slip.hpp"

#include <array>

namespace stridor::model {

/// Coulomb friction with two coefficients each way: bristles, fibres, a grain that is stroked or ruffled.
///
///     stick  -mu_s(forward) N <= T <= mu_s(backward) N        slip  T = -mu_d(forward) N or +mu_d(backward) N
struct Directional {
    std::array<double, 2> static_coefficients{};   // [1] mu_s, shape [slip]
    std::array<double, 2> kinetic_coefficients{};  // [1] mu_d <= mu_s, shape [slip]

    bool operator==(const Directional&) const = default;
};

/// As every law of friction: see `friction/law.hpp`.
double stick_limit(const Directional& law, Slip way);

/// Likewise.
double slip_ratio(const Directional& law, Slip way);

}  // namespace stridor::model
