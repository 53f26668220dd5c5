#pragma once

#include "stridor/model/friction.hpp"

#include <span>

/// The laws of friction along a motion: with the speed of slip as a power series in time, their resistance is one, too.
namespace stridor::model {

/// Which stretch a speed belongs to that stands on the corner between two.
enum class CornerSide { below, above };

/// Returns the stretch of a speed of slip [m/s]; within `rounding` [m/s] of a corner, the one on that side.
SpeedStretch speed_stretch(const FrictionLaw& law, Slip way, double speed, double rounding, CornerSide side);

/// Can the law's resistance be expanded, whatever the speed of slip?
bool has_jet(const FrictionLaw& law);

/// The power series of a law's resistance [1] along one of the speed of slip, one coefficient after the other.
///
/// A coefficient follows from those of the speed up to it by the recurrences of the law's functions (Moore 1966), which
/// use +, -, * and / in a fixed order: the same bits on every machine.
class FrictionJet {
public:
    FrictionJet(const FrictionLaw& law, Slip way) : law_(&law), way_(way) {}

    /// Chooses the stretch whose function is expanded; before the second coefficient is asked for.
    void choose(const SpeedStretch& stretch) { terms_.stretch = stretch; }

    /// Returns the next coefficient, from those of the speed [m/s] up to it.
    double next(std::span<const double> speed);

private:
    const FrictionLaw* law_;
    Slip way_;
    JetTerms terms_{};
};

}  // namespace stridor::model
