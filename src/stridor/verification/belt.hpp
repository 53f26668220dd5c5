#pragma once

#include "stridor/verification/check.hpp"

#include <vector>

/// Stick-slip of a mass on a belt, undamped: m x'' + k x = T, N = F. With w0 = sqrt(k/m), D = (mu_s - mu_d) F / k and
/// lambda = w0 D / V it sticks for 2 lambda / w0 and slips for 2 (pi - atan lambda) / w0.
namespace stridor::verification {

/// How long it sticks in each period, from lambda [1] and w0 [rad/s].
double belt_stick_time(double lambda, double w0);  // [s]

/// Likewise, how long it slips.
double belt_slip_time(double lambda, double w0);  // [s]

/// [s] the sum of both.
double belt_period(double lambda, double w0);

/// [1] the share of the period that it sticks; the same for every w0.
double belt_stick_fraction(double lambda);

/// Stick fractions of both engines.
std::vector<Check> belt_checks();

}  // namespace stridor::verification
