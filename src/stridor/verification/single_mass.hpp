#pragma once

#include "stridor/verification/check.hpp"

#include <array>
#include <vector>

namespace stridor::verification {

// Stick-slip of a mass on a belt, undamped: m x'' + k x = T, N = F. With w0 = sqrt(k/m), D = (mu_s - mu_d) F / k and
// lambda = w0 D / V it sticks for 2 lambda / w0 and slips for 2 (pi - atan lambda) / w0.

/// Returns how long it sticks in each period [s], from lambda [1] and w0 [rad/s].
double belt_stick_time(double lambda, double w0);  // [s]

/// Returns how long it slips in each period [s], from lambda [1] and w0 [rad/s].
double belt_slip_time(double lambda, double w0);  // [s]

/// Returns the period [s], the sum of both.
double belt_period(double lambda, double w0);

/// Returns the share of the period in which it sticks [1]; it does not depend on w0.
double belt_stick_fraction(double lambda);

/// Returns the checks of the stick fractions of both engines.
std::vector<Check> belt_checks();

/// The mass on a belt that is too fast to be reached: it slips for ever, a damped oscillator about mu_d F / k.
struct DampedSlip {
    double equilibrium = 0.0;  // [m] mu_d F / k
    double push = 0.0;         // [m/s] velocity beyond the equilibrium's at t = 0
    double decay = 0.0;        // [1/s] zeta w0 = c / (2 m)
    double rate = 0.0;         // [rad/s] w0 sqrt(1 - zeta^2)
};

/// Returns x(t) = equilibrium + push / rate exp(-decay t) sin(rate t) [m].
double displacement(const DampedSlip& slip, double time);

/// Returns the checks of the order of beta_2, observed from its errors at steps h and h / 2.
std::vector<Check> order_checks();

// Den Hartog (1931): x'' + x = cos(g t + phase) - r sign(x') moves with amplitude sqrt(v^2 - r^2 u^2), where
// v = 1 / (1 - g^2) and u = sin(pi / g) / (g (1 + cos(pi / g))), as long as it never stops.
//
// Force excitation becomes base excitation, a mass on a shaken belt: with m = k = 1 and x2 = A sin(g t),
// z = x1 - x2 obeys z'' + z = (g^2 - 1) A sin(g t) - r sign(z'). A = 1 / (g^2 - 1) gives a force of unit amplitude.

/// Returns the closed form above [1].
double den_hartog_amplitude(double g, double r);

/// One of Den Hartog's motions that never stop.
struct DenHartog {
    double g = 0.0;          // [1] frequency of the force over the natural one
    double r = 0.0;          // [1] friction over the force's amplitude
    double amplitude = 0.0;  // [1] as published, six digits
};

inline constexpr std::array<DenHartog, 3> den_hartog_motions{
    {{1.5, 0.2, 0.765942}, {1.5, 0.6, 0.400000}, {2.0, 0.4, 0.266667}}};

/// Returns the checks of the amplitudes of both engines.
std::vector<Check> den_hartog_checks();

}  // namespace stridor::verification
