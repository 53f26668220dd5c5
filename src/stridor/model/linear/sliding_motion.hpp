#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <complex>
#include <vector>

/// The motion of a small disturbance while no contact changes its state.
///
/// Contacts that slip hold n.u and push along b = n + ratio t. Contacts that stick hold n.u and t.u and push along
/// both. The columns of Q span the motions that keep these held, and no contact pushes P = Q - R (B'R)⁻¹ B'Q:
///
///     P.M Q q'' + P.C Q q' + P.K Q q = 0
///
/// Friction makes P.K Q unsymmetric, and with several contacts P.M Q too: modes may grow.
namespace stridor::model {

/// A friction state near steady sliding: z' = rate z + rate_by_slip w, and friction pushes with force z along t.
struct SlidingState {
    std::size_t contact = 0;
    Eigen::VectorXd tangent;    // [1] t, shape [dof]
    double force = 0.0;         // [N]
    double rate = 0.0;          // [1/s]
    double rate_by_slip = 0.0;  // [1/m]
};

/// The motion near a set of contact states, M u'' + C u' + K u = B lambda + sum of t force z, with R'u held.
struct SlidingMotion {
    Eigen::MatrixXd mass;       // [kg] M
    Eigen::MatrixXd damping;    // [N*s/m] C
    Eigen::MatrixXd stiffness;  // [N/m] K
    Eigen::MatrixXd held;       // [1] R: n of each closed contact, and t of each that sticks; shape [dof][held]
    Eigen::MatrixXd forces;     // [1] B: the directions of the pushes along them, shape [dof][held]
    std::vector<SlidingState> states{};
};

/// Returns the motion of a structure near these contact states. `ratios` [1] are T/N of the slipping contacts; both of
/// shape [contact]. For a friction law that is not state-wise `add_slopes` adds the rest.
SlidingMotion sliding_motion(const Structure& structure, const std::vector<ContactState>& states,
                             const std::vector<double>& ratios);

/// Adds the effect of friction that changes with the slip velocity, near steady sliding over a surface of this velocity
/// [m/s] with these normal forces [N], shape [contact]: dT = N dr/dw dw damps the motion along t by -N dr/dw. A law
/// with a friction state damps by what changes at once, and adds that state.
void add_slopes(SlidingMotion& motion, const Structure& structure, const std::vector<ContactState>& states,
                double surface_velocity, const Eigen::VectorXd& normal_forces);

/// Says whether each motion that the contacts allow moves some mass. A contact may hold a row without mass.
bool has_inertia(const SlidingMotion& motion);

/// A motion in first order, z' = A z: z holds the positions in the directions Q, in units of a velocity, then the
/// velocities, then the friction states, in units in which they give as much as they take.
struct FirstOrderMotion {
    Eigen::MatrixXd matrix;      // [1/s] A
    Eigen::MatrixXd directions;  // [1] Q, shape [dof][dofs - held]
};
FirstOrderMotion first_order(const SlidingMotion& motion);

/// Returns the eigenvalues of the motion [1/s], 2 (dofs - held) of them and one for each friction state; complex ones
/// stand in conjugate pairs.
std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion);

/// Returns a growth up to which eigenvalues say nothing [1/s]: the real part of an undamped mode is rounding of the
/// largest eigenvalue.
double growth_rounding(const std::vector<std::complex<double>>& eigenvalues);

}  // namespace stridor::model
