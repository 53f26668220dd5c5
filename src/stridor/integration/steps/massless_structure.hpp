#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

namespace stridor::integration {

/// A structure whose contacts move without inertia: some modes keep theirs, of all others the flexibility is left
/// (MacNeal 1971). With the contact forces lambda, at the rows of the contacts (`ContactRowPlan`) and in all of u
///
///     place = R q + G lambda + place of the load + place of the imposed force F,   u = shapes q + U lambda + ...
///
/// Forces at contacts are then those of springs, K = G^-1, in series with the modes; no impact law is needed.
struct MasslessStructure {
    ModalStructure modal;  // of the modes that keep their inertia
    ContactRowPlan plan;
    Eigen::MatrixXd flexibility;    // [m/N] G, shape [row][row]
    Eigen::VectorXd load_place;     // [m] of the rows, shape [row]
    Eigen::VectorXd shaken_place;   // [m/N] likewise, per imposed force
    Eigen::MatrixXd moved;          // [m/N] U, shape [dof][row]
    Eigen::VectorXd load_moved;     // [m] of all degrees of freedom, shape [dof]
    Eigen::VectorXd shaken_moved;   // [m/N] likewise, per imposed force
    double load_by_load = 0.0;      // [N m] f0'S f0, S the flexibility of all
    double load_by_shaken = 0.0;    // [m] f0'S shaken
    double shaken_by_shaken = 0.0;  // [m/N]
    double least_cut = 0.0;         // [rad/s] frequency of the first mode without inertia; 0: none has lost it
};

/// Takes the inertia away from all modes above `above` [Hz]; 0: from as few as leave the motion of the others that of
/// the structure, or from none but the rows that have no mass where there are such and no mode was left out.
///
/// Contacts are held by the flexibility of what has no inertia. Where it is stiff, the modes vibrate against it at
/// frequencies that the structure does not have, and friction feeds them. So modes count as carried if contacts have a
/// flexibility of their own, fewer directions than there are modes, with all held no frequency far above the first mode
/// without inertia, and slide without friction at the frequencies of the structure, up to half of that.
///
/// Throws `Error` (input) where no mode is left, where the modes are not carried, and where what is left without
/// inertia is not held by stiffness or has dampers at rows without mass.
MasslessStructure massless_structure(const model::Structure& structure, double above);

/// Returns the longest time step [s]: 2 over the highest frequency of the modes with all contacts held by their
/// flexibility, the limit of the leapfrog scheme.
double longest_step(const MasslessStructure& structure);

}  // namespace stridor::integration
