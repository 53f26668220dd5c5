#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <complex>
#include <vector>

/// What a small disturbance does while no contact changes its state.
///
/// Contacts that slip hold n.u and push along b = n + ratio t; those that stick hold n.u and t.u and push along both.
/// With the columns of Q spanning the motions that hold all of it and P = Q - R (B'R)⁻¹ B'Q, which no contact pushes,
///
///     P.M Q q'' + P.C Q q' + P.K Q q = 0
///
/// Friction makes P.K Q unsymmetric, and of several contacts P.M Q: modes may grow.
namespace stridor::model {

/// The motion near a set of contact states, M u'' + C u' + K u = B lambda with R'u held.
struct SlidingMotion {
    Eigen::MatrixXd mass;       // [kg] M
    Eigen::MatrixXd damping;    // [N*s/m] C
    Eigen::MatrixXd stiffness;  // [N/m] K
    Eigen::MatrixXd held;       // [1] R: n of each closed contact, and t of each that sticks; shape [dof][held]
    Eigen::MatrixXd forces;     // [1] B: what pushes along them, shape [dof][held]
};

/// The motion of a structure near these states. `ratios` [1] are T/N of those that slip; both of shape [contact]. Of a
/// law of friction that is not state-wise `add_slopes` says the rest.
SlidingMotion sliding_motion(const Structure& structure, const std::vector<ContactState>& states,
                             const std::vector<double>& ratios);

/// Adds what a change of friction with the slip velocity does near steady sliding over a surface of this velocity
/// [m/s], pressed by these normal forces [N], shape [contact]: dT = N dr/dw dw damps the motion along t by -N dr/dw.
void add_slopes(SlidingMotion& motion, const Structure& structure, const std::vector<ContactState>& states,
                double surface_velocity, const Eigen::VectorXd& normal_forces);

/// Does each motion that the contacts allow move some mass? A row without any may be held by a contact.
bool has_inertia(const SlidingMotion& motion);

/// A motion in first order, z' = A z: z holds the positions in the directions Q, in units of a velocity, then the
/// velocities.
struct FirstOrderMotion {
    Eigen::MatrixXd matrix;      // [1/s] A
    Eigen::MatrixXd directions;  // [1] Q, shape [dof][dofs - held]
};
FirstOrderMotion first_order(const SlidingMotion& motion);

/// Its eigenvalues [1/s], 2 (dofs - held) of them, complex ones in conjugate pairs.
std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion);

/// A growth up to which eigenvalues say nothing [1/s]: an undamped mode's real part comes out as rounding of the
/// largest.
double growth_rounding(const std::vector<std::complex<double>>& eigenvalues);

}  // namespace stridor::model
