#pragma once

#include "stridor/verification/check.hpp"

#include <array>
#include <vector>

/// Den Hartog (1931): x'' + x = cos(g t + phase) - r sign(x') moves with amplitude sqrt(v^2 - r^2 u^2), where
/// v = 1 / (1 - g^2) and u = sin(pi / g) / (g (1 + cos(pi / g))), as long as it never stops.
///
/// Force excitation becomes base excitation, a mass on a shaken belt: with m = k = 1 and x2 = A sin(g t),
/// z = x1 - x2 obeys z'' + z = (g^2 - 1) A sin(g t) - r sign(z'). A = 1 / (g^2 - 1) gives a force of unit amplitude.
namespace stridor::verification {

/// [1] the closed form above.
double den_hartog_amplitude(double g, double r);

/// One of Den Hartog's motions that never stop.
struct DenHartog {
    double g = 0.0;          // [1] frequency of the force over the natural one
    double r = 0.0;          // [1] friction over the force's amplitude
    double amplitude = 0.0;  // [1] as published, six digits
};

inline constexpr std::array<DenHartog, 3> den_hartog_motions{
    {{1.5, 0.2, 0.765942}, {1.5, 0.6, 0.400000}, {2.0, 0.4, 0.266667}}};

/// Amplitudes of both engines.
std::vector<Check> den_hartog_checks();

}  // namespace stridor::verification
