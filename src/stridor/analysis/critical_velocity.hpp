#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/drive.hpp"

#include <optional>

/// The velocity below which steady sliding is lost because friction falls with the speed of slip.
///
/// At a velocity V of the surface friction damps a motion along it by N dmu/dw at w = -V: less than nothing where it
/// falls. Faster, Stribeck's curve is flatter, and the damping of the structure wins. For a mass m with a dashpot c and
/// friction that falls as exp(-V/Vs), Vc = Vs ln(N (mu_s - mu_d)/(c Vs)). Source: Bo and Pavelescu 1982; Le Rouzic, Le
/// Bot and others 2013 for the criterion c < -N dmu/dV; docs/methods/stability.md.
namespace stridor::analysis {

/// The velocities among which it is sought [m/s].
inline constexpr double slowest_sought = 1e-6;
inline constexpr double fastest_sought = 1e3;

/// Returns the largest velocity [m/s] of the surface at which steady sliding in one direction changes from lost, below,
/// to lasting, above, by complex eigenvalues: to 1e-12 of itself.
///
/// It is 0 if sliding lasts at any velocity, and infinite if it does not even last at the fastest, as with mode
/// coupling. Nothing where friction does not change with the speed of slip. Four velocities a decade are looked at: a
/// narrower loss is missed. The cost is some 80 times that of `sliding_stability`.
std::optional<double> critical_velocity(const model::Structure& structure, parameters::Direction direction);

}  // namespace stridor::analysis
