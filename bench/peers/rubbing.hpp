#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

/// What a user of a general solver writes himself: the equations of Elmaian et al. (2012) at constant V, first
/// order in time, with the event functions of each contact state and what happens at an event. All of it inlines
/// into the solvers' loops.
///
///     m1 x1'' + Cxx x1' + Cxy y1' + Kxx x1 + Kxy y1 = T
///     m1 y1'' + Cxy x1' + Cyy y1' + Kxy x1 + Kyy y1 = N - F
///     m2 y2'' + c2y y2' + k2y y2                    = F - N
namespace stridor::peers {

using model::ContactState;
using Motion = std::array<double, 6>;   // x1, y1, y2 [m], x1', y1', y2' [m/s]
using Margins = std::array<double, 2>;  // positive while the contact state lasts; [m], [N] or [m/s]

struct Mode {
    ContactState state = ContactState::slip;
    double sign = 1.0;  // [1] of the slip velocity
};

struct Rubbing {
    double m1, m2, k2y, c2y, F, mu_s, mu_d, V;  // as in docs/notation.md
    double v_s;                                 // [m/s] of Stribeck's curve; 0: mu_d is constant
    bool is_rational;                           // mu falls as 1/(1 + |w|/v_s), else as exp(-|w|/v_s)
    double kxx, kyy, kxy;                       // [N/m]
    double cxx, cyy, cxy;                       // [N*s/m]
    double per_m1, per_m2, per_total;           // [1/kg]
};

inline Rubbing rubbing(const parameters::Case& c) {
    if (c.drive.kind != parameters::DriveKind::constant || c.run.initial == parameters::Initial::sliding)
        throw std::invalid_argument("the peers run at constant velocity, started at rest or stuck");
    using parameters::FrictionKind;
    Rubbing r{};
    r.F = c.contact().preload, r.mu_s = c.contact().static_friction, r.mu_d = c.contact().kinetic_friction;
    r.V = c.drive.velocity;
    r.is_rational = c.contact().friction == FrictionKind::stribeck_rational;
    r.v_s = r.is_rational || c.contact().friction == FrictionKind::stribeck ? c.contact().stribeck_velocity : 0.0;
    // a block of one kilogram on a spring of 1 N/m, whose normal force is its preload
    if (c.own_structure != nullptr) {
        r.m1 = r.m2 = r.per_m1 = r.per_m2 = r.kxx = 1.0;
        r.per_total = 0.5;
        return r;
    }
    const double angle = c.joint().incidence_angle * 3.14159265358979323846 / 180.0;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double cc = cosine * cosine, ss = sine * sine, sc = sine * cosine;
    const parameters::Joint& joint = c.joint();
    r.m1 = joint.mass, r.m2 = c.plate.mass;
    r.k2y = c.plate.stiffness, r.c2y = c.plate.damping;
    r.kxx = joint.axial_stiffness * cc + joint.flexural_stiffness * ss;
    r.kyy = joint.axial_stiffness * ss + joint.flexural_stiffness * cc;
    r.kxy = (joint.axial_stiffness - joint.flexural_stiffness) * sc;
    r.cxx = joint.axial_damping * cc + joint.flexural_damping * ss;
    r.cyy = joint.axial_damping * ss + joint.flexural_damping * cc;
    r.cxy = (joint.axial_damping - joint.flexural_damping) * sc;
    r.per_m1 = 1.0 / r.m1, r.per_m2 = 1.0 / r.m2, r.per_total = 1.0 / (r.m1 + r.m2);
    return r;
}

inline double joint_x(const Rubbing& r, const double* s) {
    return r.cxx * s[3] + r.cxy * s[4] + r.kxx * s[0] + r.kxy * s[1];
}

inline double joint_y(const Rubbing& r, const double* s) {
    return r.cxy * s[3] + r.cyy * s[4] + r.kxy * s[0] + r.kyy * s[1];
}

inline double plate_y(const Rubbing& r, const double* s) {
    return r.c2y * s[5] + r.k2y * s[2];
}

/// Coefficient of a slip [1], of this slip velocity [m/s].
inline double coefficient(const Rubbing& r, double w) {
    if (r.v_s == 0.0) return r.mu_d;
    const double speed = std::abs(w) / r.v_s;
    return r.mu_d + (r.mu_s - r.mu_d) * (r.is_rational ? 1.0 / (1.0 + speed) : std::exp(-speed));
}

/// N of a closed contact [N].
inline double normal_force(const Rubbing& r, const double* s) {
    return r.F + (r.m2 * joint_y(r, s) - r.m1 * plate_y(r, s)) * r.per_total;
}

/// Derivatives of the motion; both arrays of shape [6].
inline void derivative(const Rubbing& r, Mode mode, const double* s, double* d) {
    const double jx = joint_x(r, s), jy = joint_y(r, s), plate = plate_y(r, s);
    d[0] = s[3], d[1] = s[4], d[2] = s[5];
    if (mode.state == ContactState::separation) {
        d[3] = -jx * r.per_m1;
        d[4] = -(r.F + jy) * r.per_m1;
        d[5] = (r.F - plate) * r.per_m2;
        return;
    }
    const double N = r.F + (r.m2 * jy - r.m1 * plate) * r.per_total;
    d[3] = mode.state == ContactState::stick ? 0.0 : -(mode.sign * coefficient(r, s[3] - r.V) * N + jx) * r.per_m1;
    d[4] = d[5] = -(jy + plate) * r.per_total;
}

/// The two event functions of a contact state; an open contact has one, the second is constant.
inline Margins margins(const Rubbing& r, Mode mode, const double* s) {
    if (mode.state == ContactState::separation) return {s[1] - s[2], 1.0};
    const double N = normal_force(r, s);
    if (mode.state == ContactState::slip) return {N, mode.sign * (s[3] - r.V)};
    const double T = joint_x(r, s);
    return {r.mu_s * N - T, r.mu_s * N + T};
}

inline Mode without_slip(const Rubbing& r, const Motion& s) {
    const double T = joint_x(r, s.data());
    if (std::abs(T) <= r.mu_s * normal_force(r, s.data())) return {ContactState::stick, 1.0};
    return {ContactState::slip, T > 0.0 ? -1.0 : 1.0};
}

inline Mode closed(const Rubbing& r, const Motion& s) {
    if (normal_force(r, s.data()) < 0.0) return {ContactState::separation, 1.0};
    const double w = s[3] - r.V;
    return w == 0.0 ? without_slip(r, s) : Mode{ContactState::slip, w > 0.0 ? 1.0 : -1.0};
}

/// Plastic impact, the tangential impulse inside the friction cone.
inline Mode impact(const Rubbing& r, Motion& s) {
    const double common = (r.m1 * s[4] + r.m2 * s[5]) * r.per_total;
    const double impulse = r.m1 * (common - s[4]), w = s[3] - r.V;
    const bool stops = r.m1 * std::abs(w) <= r.mu_s * impulse;
    // the coefficient is that of the slip velocity which the impact leaves
    double left = w;
    for (int turn = 0; !stops && turn < (r.v_s > 0.0 ? 100 : 1); ++turn)
        left = w - std::copysign(coefficient(r, left) * impulse * r.per_m1, w);
    s[3] = stops ? r.V : r.V + left;
    s[4] = s[5] = common;
    s[1] = s[2] = (r.m1 * s[1] + r.m2 * s[2]) * r.per_total;
    return closed(r, s);
}

/// The state after margin number `which` fell through zero; puts the motion where the event leaves it.
inline Mode change(const Rubbing& r, Mode mode, std::size_t which, Motion& s) {
    if (mode.state == ContactState::separation) return impact(r, s);
    if (mode.state == ContactState::stick) return {ContactState::slip, which == 0 ? -1.0 : 1.0};
    if (which == 0) return {ContactState::separation, 1.0};
    s[3] = r.V;
    return without_slip(r, s);
}

inline ContactState told(const Rubbing&, Mode mode) {
    return mode.state;
}

inline Motion first_motion(const Rubbing& r, const parameters::Case& c) {
    return {0.0, 0.0, 0.0, c.run.initial == parameters::Initial::stuck ? r.V : 0.0, 0.0, 0.0};
}

/// Adds a change of state to a history; a slip that goes on as a slip, or a rebound, is none.
inline void note(record::ContactHistory& history, ContactState state, double time) {
    if (!history.empty() && history.back().state == state) return;
    if (!history.empty()) history.back().to = time;
    history.push_back({state, time, time, 0.0, 0.0});
}

/// More events within so short a time are chatter: a peer that gets there has failed.
inline constexpr int most_events = 1000;        // [1]
inline constexpr double chatter_period = 1e-5;  // [s]

/// Throws std::runtime_error when events follow each other without end.
struct ChatterGuard {
    double since = 0.0;  // [s]
    int events = 0;

    void count(double time) {
        if (time > since + chatter_period) since = time, events = 0;
        if (++events > most_events) throw std::runtime_error("the contact chatters");
    }
};

}  // namespace stridor::peers
