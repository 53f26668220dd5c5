#pragma once

#include "stridor/model/friction.hpp"
#include "stridor/model/impact.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string_view>
#include <vector>

namespace stridor::model {

/// A point at which a structure rubs on a surface that moves with the imposed velocity V(t).
struct ContactPoint {
    Eigen::VectorXd normal;    // [1] n, shape [dof]: gap g = g0 + n.u
    Eigen::VectorXd tangent;   // [1] t, shape [dof]: tangential position t.u
    double initial_gap = 0.0;  // [m] g0
    FrictionLaw friction{};
    ImpactLaw impact{};
    double drive_share = 1.0;  // [1] of V(t) that the surface has here
    // [1] the other direction of slip, shape [dof]: friction has a circular cone then; empty: slip is along t alone
    Eigen::VectorXd second_tangent{};
    double second_drive_share = 0.0;  // [1] of V(t) along it
    int interface = -1;    // contacts of one number are one interface, judged as a whole; below 0: one by itself
    double preload = 0.0;  // [N] N at rest, which its growth is held against; 0: not known, or open there
};

/// A linear structure with unilateral frictional contacts, what every engine sees:
///
///     M u'' + C u' + K u = f0 + shaken F(t) + sum over contacts of (n N + t T)
///     gap g = g0 + n.u >= 0,    slip velocity w = t.u' - share V,    N >= 0
///
/// Displacements are measured from the preloaded rest position. The paper's joint on a plate is one builder
/// (`rubbing_system`), the mass on a belt another (`mass_on_belt`). It may have any number of degrees of freedom and of
/// contacts; an engine refuses by name what it cannot solve.
struct Structure {
    Eigen::MatrixXd mass;       // [kg] M, symmetric, positive definite, shape [dof][dof]
    Eigen::MatrixXd damping;    // [N*s/m] C, symmetric, shape [dof][dof]
    Eigen::MatrixXd stiffness;  // [N/m] K, symmetric, shape [dof][dof]
    Eigen::VectorXd load;       // [N] f0, constant, shape [dof]
    std::vector<ContactPoint> contacts;
    Eigen::VectorXd shaken{};  // [1] share of an imposed force that acts on each; shape [dof]; empty: none does
    // [1] what is recorded as vibration: the velocities measured * u'; shape [channel][dof]; empty: u' itself
    Eigen::MatrixXd measured{};
    double left_out_above = 0.0;  // [Hz] modes above it were left out when it was made; 0: none were
    std::vector<int> body{};      // number of the body that each channel belongs to, rising; empty: each its own
};

/// Matrices and load of zeros for so many degrees of freedom, and as many contacts with normals and tangents of zeros.
Structure structure_of_size(int dofs, int contacts = 1);

/// The number of each contact's interface; shape [contact].
std::vector<int> interfaces_of(const Structure& structure);

/// Number of degrees of freedom.
int dofs_of(const Structure& structure);

/// Number of channels of its vibration.
int channels_of(const Structure& structure);

/// The numbers of the contacts in the order of their rows, gaps and shares of the drive. It does not depend on how they
/// are numbered, for sums whose bits must not.
std::vector<std::size_t> canonical_order(const Structure& structure);

/// The structure with its contacts in that order.
Structure in_canonical_order(const Structure& structure);

/// The contact of a structure that has one, closed at rest, on a surface that moves with all of V(t). `solver` says who
/// can solve no other: throws `Error` (input) with its name.
const ContactPoint& only_contact(const Structure& structure, std::string_view solver);

/// Can a contact slip in two directions?
inline bool has_two_tangents(const ContactPoint& contact) {
    return contact.second_tangent.size() != 0;
}

/// Refuses a structure with a contact that slips in two directions, for a `solver` that knows one: throws `Error`
/// (input) with its name.
void expect_one_tangent(const Structure& structure, std::string_view solver);

}  // namespace stridor::model
