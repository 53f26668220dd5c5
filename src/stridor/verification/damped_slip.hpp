#pragma once

#include "stridor/verification/check.hpp"

#include <vector>

namespace stridor::verification {

/// The mass on a belt too fast to be reached: it slips for ever, a damped oscillator about mu_d F / k.
struct DampedSlip {
    double equilibrium = 0.0;  // [m] mu_d F / k
    double push = 0.0;         // [m/s] velocity beyond the equilibrium's at t = 0
    double decay = 0.0;        // [1/s] zeta w0 = c / (2 m)
    double rate = 0.0;         // [rad/s] w0 sqrt(1 - zeta^2)
};

/// [m] x(t) = equilibrium + push / rate exp(-decay t) sin(rate t).
double displacement(const DampedSlip& slip, double time);

/// The order of beta_2, observed from its errors at steps h and h / 2.
std::vector<Check> order_checks();

}  // namespace stridor::verification
