#pragma once

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <vector>

/// What the modes of steady sliding are made of, and what feeds them.
///
/// A mode u = Re(psi exp(lambda t)) with lambda^2 M psi + lambda C psi + K psi = b N and n.psi = 0 at closed contacts.
/// Its free modes are those of the same contacts without friction, K phi = omega^2 M phi, phi.M phi = 1, which span all
/// motions that keep the gaps closed: psi = sum of a phi, a = phi.M psi.
///
///     energy share  s = |a|^2 / sum of |a|^2      of the kinetic energy, all of them together 1
///     MAC           |phi.psi|^2 / (phi.phi psi*.psi), of the rows as they are
///
/// Multiplied by the conjugate velocity, the equation is a balance of power: with the mean energy of a cycle
/// E = (|lambda|^2 psi*.M psi + psi*.K psi) / 4, friction T = sigma mu_d N and slip velocity w = lambda t.psi,
///
///     Re(lambda) = sum over contacts of Re(T w*) / (4 E) - |lambda|^2 psi*.C psi / (4 E)
///
/// so each contact adds a growth of its own, and damping takes one away. docs/methods/stability.md.
namespace stridor::analysis {

/// One mode of steady sliding.
struct SlidingMode {
    std::complex<double> eigenvalue;     // [1/s] lambda
    Eigen::VectorXcd shape;              // [1] psi, its largest row 1; shape [dof]
    std::vector<double> energy_shares;   // [1] shape [free mode]
    std::vector<double> mac;             // [1] shape [free mode]
    std::vector<double> contact_growth;  // [1/s] that friction adds, shape [contact]; 0 of an open one
    double damping_growth = 0.0;         // [1/s] that damping adds, not positive
};

/// The modes that grow, by falling growth.
struct SlidingModes {
    std::vector<double> free_frequencies;  // [Hz] of the free modes, rising
    std::vector<SlidingMode> modes;
};

/// The numbers of the free modes of a mode, those with most of its energy first.
std::vector<std::size_t> by_share(const SlidingMode& mode);

/// The modes of steady sliding in one direction that grow fastest: all that grow, up to `most`; where none does the
/// least damped one. None where no motion is left free. Costs as `sliding_stability`, several times.
SlidingModes sliding_modes(const model::Structure& structure, parameters::Direction direction, std::size_t most = 4);

}  // namespace stridor::analysis
