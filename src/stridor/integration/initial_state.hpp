#pragma once

#include "stridor/base/error.hpp"
#include "stridor/model/equilibrium.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <cmath>

namespace stridor::integration {

/// How a motion begins.
struct Start {
    parameters::Initial kind = parameters::Initial::rest;
    double perturbation = 0.0;  // [m/s] sliding only: added to the tangential velocity
};

template <int dofs>
struct InitialState {
    typename model::Structure<dofs>::Vector displacement;  // [m]
    typename model::Structure<dofs>::Vector velocity;      // [m/s]
};

/// Displacement and velocity at t = 0 for a start (`parameters::Initial`) over a surface that moves with velocity V.
///
/// rest and stuck begin at the preloaded rest position, sliding at the equilibrium of steady sliding with T = +-mu_d N.
/// Throws `Error`: input where sliding has no direction, numerical where steady sliding has no equilibrium with N > 0.
template <int dofs>
InitialState<dofs> initial_state(const model::Structure<dofs>& structure, const Start& start, double surface_velocity) {
    using parameters::Initial;
    using Vector = typename model::Structure<dofs>::Vector;
    if (start.kind == Initial::sliding && surface_velocity == 0.0)
        throw Error(ErrorKind::input, {"initial = \"sliding\" has no direction", "the drive stands still at the start",
                                       "Start with initial = \"rest\"."});
    const double signed_friction =
        start.kind == Initial::sliding ? std::copysign(structure.friction.kinetic_coefficient, surface_velocity) : 0.0;
    const model::Equilibrium<dofs> balance = model::equilibrium(structure, signed_friction);
    if (!(balance.normal_force > 0.0))
        throw Error(ErrorKind::numerical, {"steady sliding has no equilibrium in this direction",
                                           "its normal force would be negative: the contact digs in (sprag-slip)",
                                           "Start with initial = \"rest\"."});
    const Vector along = structure.tangent / structure.tangent.squaredNorm();
    const double speed = start.kind == Initial::rest    ? 0.0
                         : start.kind == Initial::stuck ? surface_velocity
                                                        : start.perturbation;
    return {balance.displacement, along * speed};
}

}  // namespace stridor::integration
