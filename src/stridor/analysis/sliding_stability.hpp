#pragma once

#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/linear/sliding_motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>
#include <string_view>
#include <vector>

/// Stability of steady sliding by complex eigenvalues.
///
/// Sliding with T = sigma mu_d N, sigma = sign(V), on closed contacts n.u = -g0, is a motion near a set of states
/// (`model::SlidingMotion`). Two of its modes may meet and one of the pair grows (mode coupling, flutter), or one loses
/// its stiffness (divergence, sprag-slip).
/// Source: Hoffmann et al. 2002 for mode coupling; docs/methods/stability.md.
namespace stridor::analysis {

/// The behaviour of a small disturbance of steady sliding.
enum class StabilityKind {
    stable,
    flutter,     // a growing oscillation: mode coupling
    divergence,  // a growing displacement without oscillation: a real positive eigenvalue
    locked,      // no sliding equilibrium with N > 0 exists: the contact digs in, sprag-slip
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
    double growth = 0.0;              // [1/s] largest real part
    double frequency = 0.0;           // [Hz] of the mode with it
    double normal_force = 0.0;        // [N] at the sliding equilibrium, the least; negative: the contact digs in
    std::vector<Eigenmode> modes;     // by rising frequency, then growth
    std::vector<std::size_t> open{};  // contacts that sliding lifts off, if there are several
};

/// Judges steady sliding by its eigenvalues [1/s] and the normal force [N] at its equilibrium.
///
/// It is locked if no normal force is above zero. It is unstable if a growth exceeds rounding, relative to the largest
/// eigenvalue. Without eigenvalues it is `stable`.
SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force);

/// Steady sliding of a structure in one direction, with the motion near it.
struct SteadySliding {
    model::ClosedContacts found;
    std::vector<double> ratios;   // [1] T/N, shape [contact]
    model::SlidingMotion motion;  // of the closed contacts
};
SteadySliding steady_sliding(const model::Structure& structure, parameters::Direction direction, double speed = 1.0);

/// Returns the speed [m/s] at which steady sliding is judged: the largest of a drive, or 1 if it is zero.
double sliding_speed(const parameters::Drive& drive);

/// Returns the stability of sliding of all closed contacts in one direction. The limit of the stick plays no part. The
/// cost is some 25 (2 dofs)³ operations. If there are several contacts, some may lift off; a single one is closed or
/// locked. The surface's `speed` [m/s] matters if friction changes with the slip velocity.
SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction,
                                   double speed = 1.0);

// The composition of the modes of steady sliding, and the sources of their energy.
//
// A mode u = Re(psi exp(lambda t)) with lambda^2 M psi + lambda C psi + K psi = b N and n.psi = 0 at closed contacts.
// Its free modes are those of the same contacts without friction, K phi = omega^2 M phi, phi.M phi = 1, which span all
// motions that keep the gaps closed: psi = sum of a phi, a = phi.M psi.
//
//     energy share  s = |a|^2 / sum of |a|^2      of the kinetic energy, all of them together 1
//     MAC           |phi.psi|^2 / (phi.phi psi*.psi), of the rows as they are
//
// Multiplied by the conjugate velocity, the equation is a balance of power: with the mean energy of a cycle
// E = (|lambda|^2 psi*.M psi + psi*.K psi) / 4, friction T = sigma mu_d N and slip velocity w = lambda t.psi,
//
//     Re(lambda) = sum over contacts of Re(T w*) / (4 E) - |lambda|^2 psi*.C psi / (4 E)
//
// so each contact adds a growth of its own, and damping takes one away. docs/methods/stability.md.

/// One mode of steady sliding.
struct SlidingMode {
    std::complex<double> eigenvalue;     // [1/s] lambda
    Eigen::VectorXcd shape;              // [1] psi, its largest row 1; shape [dof]
    std::vector<double> energy_shares;   // [1] shape [free mode]
    std::vector<double> mac;             // [1] shape [free mode]
    std::vector<double> contact_growth;  // [1/s] added by friction, shape [contact]; 0 for an open one
    double damping_growth = 0.0;         // [1/s] added by damping, not positive
};

/// The modes that grow, by falling growth; if none grows, the least damped one.
struct SlidingModes {
    std::vector<double> free_frequencies;  // [Hz] of the free modes, rising
    std::vector<SlidingMode> modes;
};

/// Returns the numbers of the free modes in a mode, the largest share of energy first.
std::vector<std::size_t> by_share(const SlidingMode& mode);

inline constexpr std::size_t most_sliding_modes = 4;

/// Returns the modes of steady sliding in one direction that grow fastest: all growing ones up to `most`, or the least
/// damped one if none grows, or no mode if no motion is free. Costs several times as much as `sliding_stability`.
/// Friction that changes with the slip velocity at once, at this `speed` [m/s], counts as damping.
SlidingModes sliding_modes(const model::Structure& structure, parameters::Direction direction,
                           std::size_t most = most_sliding_modes, double speed = 1.0);

}  // namespace stridor::analysis
