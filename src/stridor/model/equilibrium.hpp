#pragma once

#include "stridor/model/structure.hpp"

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
/// singular system (the divergence boundary) comes out as such; the caller decides.
Equilibrium equilibrium(const Structure& structure, const std::vector<double>& ratios);

/// T/N of each contact [1], shape [contact], over a surface that moves with this velocity [m/s], not zero: it slips the
/// other way.
std::vector<double> sliding_ratios(const Structure& structure, double surface_velocity);

}  // namespace stridor::model
