#pragma once

#include "peers/rubbing.hpp"

#include <array>
#include <cmath>
#include <cstddef>

/// The joint of `rubbing.hpp` with LuGre's friction, whose bristles bear s of T/N: one equation more, and a corner at
/// w = 0. A slip below the creep speed is told as a stick.
///
///     s' = sigma_0 b,   b = w - |w| s/g,   g = mu_d + (mu_s - mu_d) exp(-(|w|/v_s)^delta)
///     T = -(s + sigma_1 b + k_v w) N
namespace stridor::peers {

using BristledMotion = std::array<double, 7>;  // as Motion, then s [1]
using BristledMargins =
    std::array<double, 3>;  // positive while the mode lasts; N or gap, speed of slip, to the creep's

struct BristledMode {
    bool is_open = false;
    double sign = 1.0;  // [1] of the slip velocity
    bool is_slow = false;
};

struct Bristled {
    Rubbing r;
    double v_s, delta, k_v, sigma_0, sigma_1, creep_speed;  // as in docs/notation.md
};

inline Bristled bristled(const parameters::Case& c) {
    const parameters::Contact& contact = c.contact();
    return {rubbing(c),
            contact.stribeck_velocity,
            contact.stribeck_exponent,
            contact.viscous_friction,
            contact.bristle_stiffness,
            contact.bristle_damping,
            c.verdict.creep_speed};
}

/// What the bristles bear in a steady slip [1].
inline double bearing(const Bristled& b, double speed) {
    const double x = speed / b.v_s;
    return b.r.mu_d + (b.r.mu_s - b.r.mu_d) * std::exp(b.delta == 1.0 ? -x : -x * x);
}

/// Derivatives of the motion; both arrays of shape [7].
inline void derivative(const Bristled& b, BristledMode mode, const double* s, double* d) {
    const Rubbing& r = b.r;
    if (mode.is_open) {
        derivative(r, {ContactState::separation, 1.0}, s, d);
        d[6] = 0.0;
        return;
    }
    const double jx = joint_x(r, s), jy = joint_y(r, s), plate = plate_y(r, s);
    const double N = r.F + (r.m2 * jy - r.m1 * plate) * r.per_total;
    const double w = s[3] - r.V, speed = mode.sign * w;
    const double bend = w - speed * s[6] / bearing(b, speed);
    d[0] = s[3], d[1] = s[4], d[2] = s[5];
    d[3] = -((s[6] + b.sigma_1 * bend + b.k_v * w) * N + jx) * r.per_m1;
    d[4] = d[5] = -(jy + plate) * r.per_total;
    d[6] = b.sigma_0 * bend;
}

inline BristledMargins margins(const Bristled& b, BristledMode mode, const double* s) {
    if (mode.is_open) return {s[1] - s[2], 1.0, 1.0};
    const double speed = mode.sign * (s[3] - b.r.V);
    return {normal_force(b.r, s), speed, mode.is_slow ? b.creep_speed - speed : speed - b.creep_speed};
}

inline BristledMode closed(const Bristled& b, const BristledMotion& s) {
    if (normal_force(b.r, s.data()) < 0.0) return {true, 1.0, false};
    const double w = s[3] - b.r.V, pull = joint_x(b.r, s.data());
    const bool is_backward = w != 0.0 ? w < 0.0 : pull > 0.0 || (pull == 0.0 && b.r.V > 0.0);
    return {false, is_backward ? -1.0 : 1.0, std::abs(w) < b.creep_speed};
}

/// The mode after margin number `which` fell through zero; puts the motion where the event leaves it.
inline BristledMode change(const Bristled& b, BristledMode mode, std::size_t which, BristledMotion& s) {
    const Rubbing& r = b.r;
    if (mode.is_open) {
        const double common = (r.m1 * s[4] + r.m2 * s[5]) * r.per_total;
        const double impulse = r.m1 * (common - s[4]), w = s[3] - r.V;
        // bristles have no time to bend: friction of a steady slip
        double left = w;
        for (int turn = 0; turn < 100; ++turn) {
            const double speed = std::abs(left);
            left = w - std::copysign((bearing(b, speed) + b.k_v * speed) * impulse * r.per_m1, w);
        }
        s[3] = r.m1 * std::abs(w) <= r.mu_s * impulse ? r.V : r.V + left;
        s[4] = s[5] = common;
        s[1] = s[2] = (r.m1 * s[1] + r.m2 * s[2]) * r.per_total;
        return closed(b, s);
    }
    if (which == 0) {
        s[6] = 0.0;
        return {true, 1.0, false};
    }
    if (which == 2) return {false, mode.sign, !mode.is_slow};
    s[3] = r.V;
    return {false, -mode.sign, mode.is_slow};
}

inline ContactState told(const Bristled&, BristledMode mode) {
    if (mode.is_open) return ContactState::separation;
    return mode.is_slow ? ContactState::stick : ContactState::slip;
}

inline BristledMotion first_motion(const Bristled& b, const parameters::Case& c) {
    const Motion s = first_motion(b.r, c);
    return {s[0], s[1], s[2], s[3], s[4], s[5], 0.0};
}

}  // namespace stridor::peers
