#pragma once

#include "stridor/model/laws/friction.hpp"
#include "stridor/model/laws/measured_curve.hpp"

#include <span>

/// The laws of friction along a motion: with the speed of slip as a power series in time, their resistance is one, too.
namespace stridor::model {

/// Returns the stretch of a speed of slip [m/s]; within `rounding` [m/s] of a corner, the one on that side.
SmoothStretch speed_stretch(const FrictionLaw& law, Slip way, double speed, double rounding, CornerSide side);

/// Returns over what change from a speed of slip [m/s] the last terms of a series tell whether it has converged.
double told_change(const FrictionLaw& law, double speed);

/// Says whether the law's resistance can be expanded, whatever the speed of slip.
bool has_jet(const FrictionLaw& law);

/// The power series of a law's resistance [1] along one of the speed of slip, one coefficient after the other.
///
/// A coefficient follows from those of the speed up to it by the recurrences of the law's functions (Moore 1966), which
/// use +, -, * and / in a fixed order: the same bits on every machine.
class FrictionJet {
public:
    /// `state`: the friction state at the beginning, as a slip that way has it; `step` [s]: the unit of time.
    FrictionJet(const FrictionLaw& law, Slip way, double state = 0.0, double step = 1.0)
        : law_(&law),
          way_(way),
          step_(step) {
        terms_.state[0] = state;
    }

    /// Chooses the stretch whose function is expanded; before the second coefficient is asked for.
    void choose(const SmoothStretch& stretch) { terms_.stretch = stretch; }

    /// Returns the next coefficient, from those of the speed [m/s] up to it.
    double next(std::span<const double> speed);

    /// Returns the coefficient of the friction state that goes with the one returned last.
    double state() const { return terms_.state[terms_.last()]; }

private:
    const FrictionLaw* law_;
    Slip way_;
    double step_;
    JetTerms terms_{};
};

}  // namespace stridor::model
