#pragma once

#include "stridor/integration/modal_structure.hpp"
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

/// Takes the inertia away from all modes above `above` [Hz]; 0: from as few as give the contacts a flexibility of their
/// own, or from none but the rows that have no mass where there are such.
///
/// Throws `Error` (input) where no mode is left, where what is left without inertia is not held by stiffness or has
/// dampers at rows without mass, or where it is too stiff to tell the contacts' forces apart: their flexibility is
/// singular, and more modes must lose their inertia.
MasslessStructure massless_structure(const model::Structure& structure, double above);

/// Longest time step [s]: 2 over the highest frequency of the modes with all contacts held by their flexibility, the
/// limit of the leapfrog scheme.
double longest_step(const MasslessStructure& structure);

}  // namespace stridor::integration
