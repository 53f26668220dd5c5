#pragma once

#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/model/structure.hpp"

/// How a contact goes on once its state has ended: by the signs of forces, velocities and what is zero by construction.
namespace stridor::integration {

/// The drive's two numbers at an instant: V, and what turns it (see `exact_tables.hpp`).
struct SurfaceNumbers {
    double velocity = 0.0;  // [m/s] V
    double partner = 0.0;   // W
};

/// The next contact state and what the change cost.
struct Transition {
    ContactMode mode = ContactMode::open;
    int multiplicity = 0;        // [1] order of the root its last event function begins with; 0: none
    Lanes state{};               // in the numbers of the new state
    double closing_speed = 0.0;  // [m/s] g' before an impact, else 0
    double slip_velocity = 0.0;  // [m/s] w when the new state begins
    double impact_loss = 0.0;    // [J]
    double friction_loss = 0.0;  // [J]
    double drive_work = 0.0;     // [J]
};

/// Returns the value of a row: a linear functional of a state.
double dot(const Lanes& row, const Lanes& s);

/// Returns what rounding may make of a row of forces: a contact that rests at the limit of friction
/// (mu_s = mu_d, and a plate that has come to a stop under a steady slip) must not leave it by rounding, nor come back
/// by it. About 1e-13 of the forces.
double force_rounding(const Lanes& row, const Lanes& s);

/// Returns the state of a closed contact with slip velocity w: at w = 0 it sticks if |T| <= mu_s N, else it slips
/// against T; it opens at once if N < 0.
Transition close_contact(const Flows& flows, const Lanes& closed_state, double slip_velocity);

/// Returns what follows when event function number `test` of a contact state has reached zero.
Transition follow(const Flows& flows, const model::ContactPoint& contact, ContactMode mode, int test,
                  const Lanes& state, const SurfaceNumbers& surface);

}  // namespace stridor::integration
