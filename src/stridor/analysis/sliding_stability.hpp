#pragma once

#include "stridor/model/equilibrium.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

/// Stability of steady sliding by complex eigenvalues.
///
/// Sliding with T = sigma mu_d N, sigma = sign(V), on the closed contact n.u = 0: with the columns of Q spanning the
/// motions that keep the gap closed and P = Q - n ((n + sigma mu_d t).Q) / (n.n + sigma mu_d n.t), which is orthogonal to the
/// contact force, P.M Q q'' + P.C Q q' + P.K Q q = P.f0. Friction makes P.K Q unsymmetric: two modes may meet and
/// one of the pair grows (mode coupling, flutter), or one loses its stiffness (divergence, sprag-slip).
/// Source: Hoffmann et al. 2002 for mode coupling; docs/methods/stability.md.
namespace stridor::analysis {

enum class StabilityKind {
    stable,
    flutter,     // a growing oscillation: mode coupling
    divergence,  // a growing displacement without oscillation: a real positive eigenvalue
    locked,      // no sliding equilibrium with N > 0 at all: the contact digs in, sprag-slip
};

inline constexpr std::array<std::string_view, 4> stability_names{"stable", "flutter", "divergence", "locked"};

/// One eigenvalue of the linearised motion; only one of a conjugate pair is listed.
struct Mode {
    double growth = 0.0;     // [1/s] real part
    double frequency = 0.0;  // [Hz] imaginary part / 2 pi, zero for a real eigenvalue
};

struct SlidingStability {
    StabilityKind kind = StabilityKind::stable;
    double growth = 0.0;        // [1/s] largest real part
    double frequency = 0.0;     // [Hz] of the mode with it
    double normal_force = 0.0;  // [N] at the sliding equilibrium; negative: the contact digs in
    std::vector<Mode> modes;    // by rising frequency, then growth
};

SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force);

/// Stability of sliding in one direction. The static friction coefficient plays no part.
template <int dofs>
SlidingStability sliding_stability(const model::Structure<dofs>& structure, parameters::Direction direction) {
    constexpr int free_dofs = dofs - 1;
    const double mu = structure.friction.kinetic_coefficient;
    const double signed_friction = direction == parameters::Direction::going ? mu : -mu;
    using Vector = typename model::Structure<dofs>::Vector;
    using Tall = Eigen::Matrix<double, dofs, free_dofs>;
    using Small = Eigen::Matrix<double, free_dofs, free_dofs>;
    using State = Eigen::Matrix<double, 2 * free_dofs, 2 * free_dofs>;

    const Vector force = structure.normal + signed_friction * structure.tangent;
    const Eigen::Matrix<double, dofs, 1> normal = structure.normal;
    const typename model::Structure<dofs>::Matrix basis = normal.householderQr().householderQ();
    const Tall right = basis.template rightCols<free_dofs>();
    const Tall left = right - normal * (force.transpose() * right) / normal.dot(force);
    const Small inverse_mass = (left.transpose() * structure.mass * right).inverse();
    State first_order = State::Zero();
    first_order.template topRightCorner<free_dofs, free_dofs>() = Small::Identity();
    first_order.template bottomLeftCorner<free_dofs, free_dofs>() =
        -inverse_mass * (left.transpose() * structure.stiffness * right);
    first_order.template bottomRightCorner<free_dofs, free_dofs>() =
        -inverse_mass * (left.transpose() * structure.damping * right);
    const Eigen::EigenSolver<State> solver(first_order, false);
    std::vector<std::complex<double>> eigenvalues;
    for (const std::complex<double>& value : solver.eigenvalues())
        eigenvalues.push_back(value);
    return classify_modes(eigenvalues, model::equilibrium(structure, signed_friction).normal_force);
}

}  // namespace stridor::analysis
