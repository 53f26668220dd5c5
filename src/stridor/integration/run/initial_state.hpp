#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::integration {

/// How a motion begins.
struct Start {
    parameters::Initial kind = parameters::Initial::rest;
    double perturbation = 0.0;  // [m/s] sliding only: added to the tangential velocity
};

/// Where a motion is at t = 0.
struct InitialState {
    Eigen::VectorXd displacement;  // [m], shape [dof]
    Eigen::VectorXd velocity;      // [m/s], shape [dof]
};

/// Displacement and velocity at t = 0 for a start (`parameters::Initial`), over a surface that moves with velocity V
/// [m/s].
///
/// rest and stuck begin at the preloaded rest position, sliding at the equilibrium of steady sliding. Several stuck
/// contacts move with their surfaces and the structure with the least kinetic energy. Throws `Error`: input where
/// sliding has no direction; numerical where some contact has no N > 0.
InitialState initial_state(const model::Structure& structure, const Start& start, double surface_velocity);

/// Returns the displacement and velocity at t = 0 for a case with a structure of the user's own, `model::structure_of`.
/// It rests where its displacements are zero; the start that it states is added. Throws as above.
InitialState initial_state(const parameters::Case& c, const model::Structure& structure, double surface_velocity);

}  // namespace stridor::integration
