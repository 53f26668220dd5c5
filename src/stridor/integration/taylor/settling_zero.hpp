#pragma once

// What counts as zero at an event of the Taylor engine, and what follows from it. Private to this folder.

#include "stridor/integration/contact_mode_of.hpp"
#include "stridor/integration/taylor/settling.hpp"

#include <cmath>

namespace stridor::integration {

inline constexpr int settling_order = 6;            // of the series that decide at an event
inline constexpr double function_rounding = 1e-11;  // [1] of the largest coefficient: what is zero
inline constexpr double term_rounding = 1e-14;      // [1] of the sum of the terms' sizes, likewise
inline constexpr double gap_rounding = 1e-12;       // [1] likewise, of gaps
// what counts as zero of a friction beyond its limit must count as zero of the slip that it leaves: c_m theta^m there
// is h W_tt c_m theta^(m+1)/(m+1) here, with m up to the order of the series
inline constexpr double slip_per_friction = settling_order + 1;  // [1] of the roundings above

/// Of the gap, and of what its rate changes in a step of time [s].
inline double gap_zero(const ModalContact& c, const TaylorState& state, double step) {
    return gap_rounding * (dot_of_sizes(c.normal, state.q) + std::abs(c.initial_gap)) +
           term_rounding * step * dot_of_sizes(c.normal, state.v);
}

/// Of the slip velocity [m/s].
inline double slip_zero(const ModalContact& c, const TaylorState& state, const SurfaceSeries& surface) {
    return function_rounding * (dot_of_sizes(c.tangent, state.v) + std::abs(c.drive_share * surface[0]));
}

/// What a contact does that closes: it slips the way it moves, or sticks.
inline ContactMode closed_mode(const ModalContact& contact, const TaylorState& state, const SurfaceSeries& surface) {
    const double w = slip_velocity(contact, state.v, surface[0]);
    return std::abs(w) > slip_zero(contact, state, surface) ? slip_mode(model::slip_of(w)) : ContactMode::stick;
}

}  // namespace stridor::integration
