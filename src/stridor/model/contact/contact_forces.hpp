#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

/// Forces and accelerations at one instant, from displacements and velocities alone.
///
/// With the inverse mass seen at the contact, Wnn = n.M^-1 n, Wnt = n.M^-1 t, Wtt = t.M^-1 t, and the acceleration
/// a_free = M^-1 (f0 - K u - C v) without contact forces:
///
///     slip:   n.a = 0, T = ratio N                N = -n.a_free / (Wnn + ratio Wnt)
///     stick:  n.a = 0, t.a = V'                   [Wnn Wnt; Wnt Wtt] (N, T) = (-n.a_free, V' - t.a_free)
///
/// A slip denominator <= 0 is a Painleve configuration: the rigid contact has no force that satisfies both laws.
namespace stridor::model {

/// A contact and its structure's acceleration at one instant.
struct Instant {
    ContactState state = ContactState::separation;
    double normal_force = 0.0;     // [N] N on the rubbed mass
    double friction_force = 0.0;   // [N] T on the rubbed mass
    Eigen::VectorXd acceleration;  // [m/s^2] u'', shape [dof]
};

/// How the other surface moves at this instant.
struct SurfaceMotion {
    double velocity = 0.0;      // [m/s] V
    double acceleration = 0.0;  // [m/s^2] V'
};

/// Throws `Error` (numerical) that names a Painleve configuration, for either direction of slip. Takes
/// `normal_compliance` Wnn and `coupling` Wnt [1/kg].
void require_no_painleve(double normal_compliance, double coupling, const FrictionLaw& friction);

/// Returns state, forces and acceleration of a structure with one contact at the displacement u [m] and velocity v
/// [m/s], both of shape [dof]. The displacement decides whether the gap is closed or open.
///
/// A gap within rounding of zero that does not open counts as closed. Throws `Error` (numerical) in a Painleve
/// configuration and `Error` (input) for a structure that `only_contact` refuses. Source: Elmaian et al. 2012 with the
/// friction cone of Coulomb; docs/methods/motion.md.
Instant instant(const Structure& structure, const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                const SurfaceMotion& surface);

}  // namespace stridor::model
