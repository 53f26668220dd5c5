#pragma once

#include "stridor/base/error.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/LU>

#include <cmath>

/// Forces and accelerations at one instant, from displacements and velocities alone.
///
/// With the inverse mass seen at the contact, Wnn = n.M^-1 n, Wnt = n.M^-1 t, Wtt = t.M^-1 t, and the acceleration
/// a_free = M^-1 (f0 - K u - C v) without contact forces:
///
///     slip:   n.a = 0, T = -sign(w) mu_d N        N = -n.a_free / (Wnn - sign(w) mu_d Wnt)
///     stick:  n.a = 0, t.a = V'                   [Wnn Wnt; Wnt Wtt] (N, T) = (-n.a_free, V' - t.a_free)
///
/// A slip denominator <= 0 is a Painleve configuration: the rigid contact has no force that satisfies both laws.
namespace stridor::model {

/// The contact and the structure's acceleration at one instant.
template <int dofs>
struct Instant {
    ContactState state = ContactState::separation;
    double normal_force = 0.0;                                                        // [N] N on the rubbed mass
    double friction_force = 0.0;                                                      // [N] T on the rubbed mass
    typename Structure<dofs>::Vector acceleration = Structure<dofs>::Vector::Zero();  // [m/s^2] u''
};

/// How the other surface moves at this instant.
struct SurfaceMotion {
    double velocity = 0.0;      // [m/s] V
    double acceleration = 0.0;  // [m/s^2] V'
};

/// Throws `Error` (numerical) naming a Painleve configuration, for either direction of slip.
void require_no_painleve(double normal_compliance, double coupling, double kinetic_friction);

/// State, forces and acceleration of a structure whose gap is closed or open by its displacement u and velocity v.
///
/// A gap within rounding of zero that does not open counts as closed. Throws `Error` (numerical) in a Painleve
/// configuration. Source: Elmaian et al. 2012 with the friction cone of Coulomb; docs/methods/motion.md.
template <int dofs>
Instant<dofs> instant(const Structure<dofs>& structure, const typename Structure<dofs>::Vector& u,
                      const typename Structure<dofs>::Vector& v, const SurfaceMotion& surface) {
    using Vector = typename Structure<dofs>::Vector;
    const typename Structure<dofs>::Matrix inverse_mass = structure.mass.inverse();
    const Vector free = inverse_mass * (structure.load - structure.stiffness * u - structure.damping * v);
    const Vector from_normal = inverse_mass * structure.normal;
    const Vector from_tangent = inverse_mass * structure.tangent;
    const double nn = structure.normal.dot(from_normal);
    const double nt = structure.normal.dot(from_tangent);
    const double tt = structure.tangent.dot(from_tangent);
    require_no_painleve(nn, nt, structure.friction.kinetic_coefficient);

    Instant<dofs> now;
    now.acceleration = free;
    const bool is_open = structure.normal.dot(u) > 0.0 || structure.normal.dot(v) > 0.0;
    if (is_open) return now;

    const double opening = structure.normal.dot(free);
    const double w = structure.tangent.dot(v) - surface.velocity;
    if (w == 0.0) {
        const double determinant = nn * tt - nt * nt;
        const double sliding = surface.acceleration - structure.tangent.dot(free);
        now.normal_force = (-opening * tt - nt * sliding) / determinant;
        now.friction_force = (nn * sliding + nt * opening) / determinant;
        now.state = ContactState::stick;
    }
    const bool holds = now.state == ContactState::stick &&
                       std::abs(now.friction_force) <= stick_limit(structure.friction, now.normal_force);
    if (!holds) {
        // a stuck contact that cannot hold slips against its friction force
        const double direction = w != 0.0 ? w : -now.friction_force;
        const double signed_friction = std::copysign(structure.friction.kinetic_coefficient, -direction);
        now.normal_force = -opening / (nn + signed_friction * nt);
        now.friction_force = signed_friction * now.normal_force;
        now.state = ContactState::slip;
    }
    if (now.normal_force < 0.0) return {ContactState::separation, 0.0, 0.0, free};
    now.acceleration = free + from_normal * now.normal_force + from_tangent * now.friction_force;
    return now;
}

}  // namespace stridor::model
