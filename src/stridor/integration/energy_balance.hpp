#pragma once

namespace stridor::integration {

/// Where the energy of a run came from and went [J].
///
///     stored = preload_work + drive_work - dashpot_loss - friction_loss - impact_loss + residual
///
/// The residual is what the numbers created (positive) or lost (negative): rounding for the central difference,
/// numerical damping for beta_2 > 0.5. It is a monitor of the computation, not of the model.
struct EnergyBalance {
    double stored = 0.0;         // change of kinetic and elastic energy
    double preload_work = 0.0;   // work of the constant load f0
    double drive_work = 0.0;     // work of the imposed motion, T V
    double dashpot_loss = 0.0;   // v.C v
    double friction_loss = 0.0;  // -T w
    double impact_loss = 0.0;    // -N g', spent when surfaces meet
    double residual = 0.0;       // what is left over

    /// The residual as a share of all energy that went in or out [1].
    double relative_residual() const;
};

/// What the other terms of a balance leave over [J]: its residual.
double unexplained(const EnergyBalance& balance);

}  // namespace stridor::integration
