#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace stridor::integration {

struct Handover;  // end_state.hpp

/// Where a motion is at t = 0.
struct InitialState {
    Eigen::VectorXd displacement;  // [m], shape [dof]
    Eigen::VectorXd velocity;      // [m/s], shape [dof]
    // of a given start what each contact does, stick, slip or separation; shape [contact]; empty: at rest all that are
    // closed stick, or slip by their velocities
    std::vector<parameters::ContactStart> contacts{};
    Handover* handover = nullptr;           // from and to other runs; null: the run begins and ends by itself
    std::vector<double> friction_states{};  // [1] of laws that have one, shape [contact]; empty: 0
};

/// Says whether a given start has this contact open.
inline bool begins_open(const InitialState& start, std::size_t contact) {
    return !start.contacts.empty() && start.contacts[contact] == parameters::ContactStart::separation;
}

/// How a motion begins.
struct Start {
    parameters::Initial kind = parameters::Initial::rest;
    double perturbation = 0.0;  // [m/s] sliding only: added to the tangential velocity
    std::optional<InitialState> given{};
    Handover* handover = nullptr;  // as that of `InitialState`
};

/// Returns displacement and velocity at t = 0 for a start (`parameters::Initial`), over a surface that moves with
/// velocity V [m/s].
///
/// rest and stuck begin at the preloaded rest position, given where the start says, sliding at the equilibrium of
/// steady sliding. Friction states begin there with those of a steady slip, else as given, or with 0. Several stuck
/// contacts move with their surfaces and the structure with the least kinetic energy.
/// Throws `Error`: input where sliding has no direction; numerical where some contact has no N > 0.
InitialState initial_state(const model::Structure& structure, const Start& start, double surface_velocity);

/// Returns the displacement and velocity at t = 0 for a case with this structure, `model::structure_of`. One of the
/// user's own rests where its displacements are zero; the start that it states is added, or is all where it is given.
/// Throws as above; input for a given start that no contact states have.
InitialState initial_state(const parameters::Case& c, const model::Structure& structure, double surface_velocity);

}  // namespace stridor::integration
