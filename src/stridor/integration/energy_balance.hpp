#pragma once

#include "stridor/integration/outcome.hpp"

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
    double drive_work = 0.0;     // work of the imposed motion, T V, or of an imposed force
    double dashpot_loss = 0.0;   // v.C v
    double friction_loss = 0.0;  // -T w
    double impact_loss = 0.0;    // -N g', spent when surfaces meet
    double residual = 0.0;       // what is left over
    double held = 0.0;           // the largest that springs, masses and the preload held at a time, a bound
    double carried = 0.0;        // what the load would do while the fastest mode turns by a radian, were it not carried

    /// The residual as a share of all energy that went in or out [1], the turnover.
    ///
    /// Rounding makes 1e-16 of the energy held, whether any of it is turned over or not: a turnover below a thousandth
    /// of it counts as that thousandth, so that a motion in which nothing happens has a residual of 1e-13 and not of 1.
    /// Contacts that carry a load cancel it but for rounding, too. That is in the energy held where springs give way,
    /// and is not where nothing does.
    double relative_residual() const;
};

/// `unbalanced` instead of a result whose relative residual is above `most_unexplained`, `diverged` instead of one
/// whose balance is no number: velocities may still be numbers where their squares no longer are.
Outcome weighed(const Outcome& outcome, const EnergyBalance& balance, double most_unexplained);

/// What the other terms of a balance leave over [J]: its residual.
double unexplained(const EnergyBalance& balance);

}  // namespace stridor::integration
