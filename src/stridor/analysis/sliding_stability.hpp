#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <Eigen/Core>

#include <array>
#include <complex>
#include <string_view>
#include <vector>

/// Stability of steady sliding by complex eigenvalues.
///
/// Sliding with T = sigma mu_d N, sigma = sign(V), on the closed contact n.u = 0: with the columns of Q spanning the
/// motions that keep the gap closed and P = Q - n ((n + sigma mu_d t).Q) / (n.n + sigma mu_d n.t), which is orthogonal
/// to the contact force, P.M Q q'' + P.C Q q' + P.K Q q = P.f0. Friction makes P.K Q unsymmetric: two modes may meet
/// and one of the pair grows (mode coupling, flutter), or one loses its stiffness (divergence, sprag-slip).
/// Source: Hoffmann et al. 2002 for mode coupling; docs/methods/stability.md.
namespace stridor::analysis {

/// What a small disturbance of steady sliding does.
enum class StabilityKind {
    stable,
    flutter,     // a growing oscillation: mode coupling
    divergence,  // a growing displacement without oscillation: a real positive eigenvalue
    locked,      // no sliding equilibrium with N > 0 at all: the contact digs in, sprag-slip
};

inline constexpr std::array<std::string_view, 4> stability_names{"stable", "flutter", "divergence", "locked"};

/// One eigenvalue of the linearised motion; only one of a conjugate pair is listed.
struct Eigenmode {
    double growth = 0.0;     // [1/s] real part
    double frequency = 0.0;  // [Hz] imaginary part / 2 pi, zero for a real eigenvalue
};

/// Stability of steady sliding, and the modes it was judged by.
struct SlidingStability {
    StabilityKind kind = StabilityKind::stable;
    double growth = 0.0;           // [1/s] largest real part
    double frequency = 0.0;        // [Hz] of the mode with it
    double normal_force = 0.0;     // [N] at the sliding equilibrium; negative: the contact digs in
    std::vector<Eigenmode> modes;  // by rising frequency, then growth
};

/// Judges steady sliding by its eigenvalues [1/s] and the normal force [N] at its equilibrium.
///
/// It is locked without a normal force above zero. It is unstable where a growth exceeds rounding, relative to the
/// largest eigenvalue. No eigenvalues give `stable`.
SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force);

/// The motion near steady sliding, M u'' + C u' + K u = b N with n.u = 0.
struct SlidingMotion {
    Eigen::MatrixXd mass;       // [kg] M
    Eigen::MatrixXd damping;    // [N*s/m] C
    Eigen::MatrixXd stiffness;  // [N/m] K
    Eigen::VectorXd normal;     // [1] n
    Eigen::VectorXd force;      // [1] b = n + sigma mu_d t
};

/// Its eigenvalues [1/s], 2 (dofs - 1) of them, complex ones in conjugate pairs.
std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion);

/// Stability of sliding in one direction, of a structure with one contact. The limit of the stick plays no part. Throws
/// `Error` (input) what `only_contact` refuses.
SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction);

}  // namespace stridor::analysis
