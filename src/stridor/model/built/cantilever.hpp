#pragma once

#include "stridor/model/structure.hpp"

namespace stridor::model {

/// A slender beam, clamped at one end, that rubs on a surface with its tip.
struct Cantilever {
    double length = 0.1;               // [m] L
    double mass_per_length = 0.024;    // [kg/m] rho A
    double bending_stiffness = 0.014;  // [N*m^2] E I
    double axial_stiffness = 4.2e4;    // [N] E A
    double damping_ratio = 0.01;       // [1] zeta, of each mode
    double incidence_angle = 60.0;     // [deg] from the surface's direction of motion to the beam's axis
    double preload = 1.0;              // [N] F, pressing the tip on the surface at rest
    Coulomb friction{0.4, 0.25};
};

/// Returns the angular frequency of bending mode number k = 1, 2, ... [rad/s]: beta² sqrt(EI / rho A), cos(beta L)
/// cosh(beta L) = -1.
double bending_frequency(const Cantilever& beam, int k);

/// Returns the beam by its first bending modes and its first axial mode, as coordinates with unit modal mass [m
/// sqrt(kg)], bending first. At the tip a bending mode moves 2 (-1)^(k+1) / sqrt(m), the axial mode sqrt(2 / m), m =
/// rho A L.
///
/// Throws `Error` (input) for less than one mode. Source: Euler and Bernoulli's beam; Meirovitch, Fundamentals of
/// Vibrations (2001), 8.4.
Structure cantilever(const Cantilever& beam, int bending_modes);

/// How far each coordinate moves a point of the beam [1/sqrt(kg)]; each of shape [bending_modes + 1].
struct BeamShape {
    Eigen::VectorXd along;   // the surface's direction of motion
    Eigen::VectorXd across;  // the surface's normal
};

/// Returns the shape at `place`, the share of the beam's length from its clamped end.
BeamShape cantilever_shape(const Cantilever& beam, int bending_modes, double place);

}  // namespace stridor::model
