#pragma once

#include "stridor/model/structure.hpp"

#include <limits>

namespace stridor::model {

/// A string that a bow rubs at one point.
struct BowedString {
    double frequency = 200.0;                                            // [Hz] of its first mode
    double impedance = 0.35;                                             // [kg/s] Z, of waves on it
    double length = 0.5;                                                 // [m] L
    double damping_ratio = 5e-4;                                         // [1] zeta, of each mode
    double bridge_resistance = std::numeric_limits<double>::infinity();  // [kg/s] R, far above Z
    double bow_position = 0.13;  // [1] b, from the near end, as a share of the length
    double bow_force = 0.8;      // [N] F
    Coulomb friction{0.8, 0.3};
};

/// Returns the string by its first modes, as coordinates with unit modal mass [m √kg], then the bow across it: a last
/// degree of freedom that carries the constant bow force and does not move.
///
///     ω_k = 2π f k,  φ_k(x) = √(2/(ρ L)) sin(kπ x/L),  ρ = Z/(2 L f)
///
/// A bridge that yields with the resistance R reflects (R - Z)/(R + Z) of a wave. A period costs each mode about 2 Z/R
/// of its amplitude: its damping is 2 ζ ω_k + 4 f Z/R.
///
/// Source: Cremer, The Physics of the Violin (1984), chapter 3.
Structure bowed_string(const BowedString& string, int modes);

/// Returns how far each coordinate moves the string [1/√kg] at `place`, the share of its length from the near end: φ_k
/// there, and 0 for the bow; shape [modes + 1].
Eigen::VectorXd string_shape(const BowedString& string, int modes, double place);

/// Returns the velocities of the coordinates [m √kg/s] in Helmholtz's motion when the string passes through its rest
/// position, for a bow of velocity V [m/s]: V/b √(2 ρ L) (-1)^(k+1) / (kπ). The corner runs round the string once a
/// period; the string sticks to the bow except during the share b of it.
Eigen::VectorXd helmholtz_motion(const BowedString& string, int modes, double bow_velocity);

/// Returns the largest bow force [N] of Helmholtz's motion, 2 Z V / (b (mu_s - mu_d)). Schelleng (1973), J. Acoust.
/// Soc. Am. 53.
double greatest_bow_force(const BowedString& string, double bow_velocity);

/// Returns the least bow force [N] of Helmholtz's motion, Z² V / (2 R b² (mu_s - mu_d)), if only the bridge loses
/// energy. Schelleng (1973).
double least_bow_force(const BowedString& string, double bow_velocity);

}  // namespace stridor::model
