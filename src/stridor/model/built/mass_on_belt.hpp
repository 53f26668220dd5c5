#pragma once

#include "stridor/model/structure.hpp"

namespace stridor::model {

/// The classic oscillator on a moving belt, pressed on it by a constant force: the contact never opens, N = F.
struct Belt {
    double mass = 1.0;       // [kg] m
    double stiffness = 1.0;  // [N/m] k, along the belt
    double damping = 0.0;    // [N*s/m] c, along the belt
    double preload = 1.0;    // [N] F
    Coulomb friction;
};

/// Returns the belt oscillator as a structure with one contact, u = (x, y) [m], along and across the belt. Only the
/// preload acts across the belt.
Structure mass_on_belt(const Belt& belt);

}  // namespace stridor::model
