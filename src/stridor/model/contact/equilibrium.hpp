#pragma once

#include "stridor/model/structure.hpp"

#include <cstddef>
#include <vector>

namespace stridor::model {

/// A state of rest or of steady sliding: displacements and normal forces that balance.
struct Equilibrium {
    Eigen::VectorXd displacement;   // [m] u, shape [dof]
    Eigen::VectorXd normal_forces;  // [N] N, shape [contact]
};

/// Solves K u = f0 + sum of (n + ratio t) N with all contacts closed, g0 + n.u = 0.
///
/// `ratios` [1] are T/N, shape [contact]: 0 at rest, `slip_ratio` while it slides. A negative normal force or a
/// singular system (the divergence boundary) shows in the result; the caller decides.
/// With springs: by Newton's method from u = 0; what comes to no end has no numbers.
Equilibrium equilibrium(const Structure& structure, const std::vector<double>& ratios);

/// A state of rest or of steady sliding in which contacts may be open.
struct ClosedContacts {
    std::vector<std::size_t> closed;  // their numbers, rising
    Equilibrium equilibrium;          // a normal force of zero where a contact is open
};

/// Returns the equilibrium in which each contact is either closed with N > 0 or open with a gap. Contacts are changed
/// one at a time, the first violated one first (Murty 1974). If no such equilibrium is found, or if there is one
/// contact, returns that of all contacts closed, with some N negative.
ClosedContacts closed_contacts(const Structure& structure, const std::vector<double>& ratios);

/// Returns T/N of each contact [1], shape [contact], over a surface that moves with this velocity [m/s], not zero. The
/// slip is opposite to that velocity.
std::vector<double> sliding_ratios(const Structure& structure, double surface_velocity);

}  // namespace stridor::model
