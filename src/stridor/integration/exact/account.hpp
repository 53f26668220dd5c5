#pragma once

#include "stridor/integration/kernels/exact_kernel.hpp"

namespace stridor::integration {

/// What the kernel has added up since the last reset, by contact state.
struct Account {
    Sums full[contact_modes]{};  // whole steps, not weighted
    Sums part[contact_modes]{};  // parts of steps, weighted
    double largest_force = 0.0;  // [N] largest N where states and spans ended
};

/// Integrals over the time since the last reset.
struct Totals {
    double square_time[most_coordinates]{};  // [m^2/s] of u'^2
    double peak_square[most_coordinates]{};  // [m^2/s^2] largest velocity squared of its body, at nodes
    double dashpot_loss = 0.0;               // [J]
    double friction_loss = 0.0;              // [J]
    double drive_work = 0.0;                 // [J]
    double largest_force = 0.0;              // [N] largest N where states and spans ended
};

/// Returns the integrals of what was added up.
Totals totals(const Flows& flows, const Account& account);

/// Adds a multiple of the integrals; of peaks the larger counts.
void add(Totals& sum, const Totals& more, double factor);

}  // namespace stridor::integration
