#pragma once

namespace stridor::model {

/// Coulomb friction with two coefficients, independent of the slip velocity (Elmaian et al. 2012, Figure 3).
struct Coulomb {
    double static_coefficient = 0.0;   // [1] mu_s
    double kinetic_coefficient = 0.0;  // [1] mu_d <= mu_s
};

/// Largest friction force that keeps the contact stuck [N]; zero for an open contact (N <= 0).
double stick_limit(const Coulomb& friction, double normal_force);

/// Friction force on the rubbed mass while slipping [N]: T = -mu_d N sign(w).
///
/// `slip_velocity` w is that of the mass relative to the moving surface [m/s]; at w = 0 the force is zero, for the
/// stuck contact's force follows from equilibrium, not from this law.
double slip_force(const Coulomb& friction, double normal_force, double slip_velocity);

}  // namespace stridor::model
