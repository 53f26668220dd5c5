#pragma once

#include "stridor/model/laws/friction.hpp"
#include "stridor/model/laws/impact.hpp"
#include "stridor/model/laws/rest.hpp"
#include "stridor/model/laws/spring.hpp"

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
    double drive_share = 1.0;  // [1] share of V(t) with which the surface moves here
    // [1] the other direction of slip, shape [dof]: friction has a circular cone then; empty: slip is along t alone
    Eigen::VectorXd second_tangent{};
    double second_drive_share = 0.0;  // [1] share of V(t) along the second tangent
    int interface = -1;               // contacts of one number are one interface, judged as a whole; below 0: alone
    double preload = 0.0;             // [N] N at rest, the reference of its growth; 0: not known, or open there
    RestGrowth rest{};                // of its static friction
    double creep_speed = 0.0;         // [m/s] of a law with a state: below it a slip counts as a stick; 0: never
};

/// A structure with unilateral frictional contacts, what every engine sees. It is linear but for its springs:
///
///     M u'' + C u' + K u + sum over springs of d F(e0 + d.u) = f0 + shaken F(t) + sum over contacts of (n N + t T)
///     gap g = g0 + n.u >= 0,    slip velocity w = t.u' - share V,    N >= 0
///
/// Displacements are measured from the preloaded rest position. The paper's joint on a plate is one builder
/// (`rubbing_system`), the mass on a belt another (`mass_on_belt`). A structure may have any number of degrees of
/// freedom and of contacts; an engine refuses by name what it cannot solve.
struct Structure {
    Eigen::MatrixXd mass;       // [kg] M, symmetric, positive definite, shape [dof][dof]
    Eigen::MatrixXd damping;    // [N*s/m] C, symmetric, shape [dof][dof]
    Eigen::MatrixXd stiffness;  // [N/m] K, symmetric, shape [dof][dof]
    Eigen::VectorXd load;       // [N] f0, constant, shape [dof]
    std::vector<ContactPoint> contacts;
    Eigen::VectorXd shaken{};  // [1] share of an imposed force on each, shape [dof]; empty: no such force
    // [1] what is recorded as vibration: the velocities measured * u'; shape [channel][dof]; empty: u' itself
    Eigen::MatrixXd measured{};
    double left_out_above = 0.0;    // [Hz] modes above it were left out when the structure was made; 0: none
    std::vector<Spring> springs{};  // beside K
    std::vector<int> body{};        // number of the body of each channel, rising; empty: one body each
};

/// Returns a structure with zero matrices and load for `dofs` degrees of freedom, and contacts with zero normals and
/// tangents.
Structure structure_of_size(int dofs, int contacts = 1);

/// Returns the number of each contact's interface; shape [contact].
std::vector<int> interfaces_of(const Structure& structure);

/// Returns the number of degrees of freedom.
int dofs_of(const Structure& structure);

/// Returns the number of channels of the vibration.
int channels_of(const Structure& structure);

/// Returns the numbers of the contacts in the order of their rows, gaps and shares of the drive. That order does not
/// depend on their numbering; sums in it keep their bits.
std::vector<std::size_t> canonical_order(const Structure& structure);

/// Returns the structure with its contacts in canonical order.
Structure in_canonical_order(const Structure& structure);

/// Returns the contact of a structure that has one, closed at rest, on a surface that moves with all of V(t). Throws
/// `Error` (input) for any other structure, with the name of the `solver` that cannot solve it.
const ContactPoint& only_contact(const Structure& structure, std::string_view solver);

/// Says whether a contact can slip in two directions.
inline bool has_two_tangents(const ContactPoint& contact) {
    return contact.second_tangent.size() != 0;
}

/// Refuses a structure with a contact that slips in two directions, for a `solver` that knows one direction: throws
/// `Error` (input) with the solver's name.
void expect_one_tangent(const Structure& structure, std::string_view solver);

}  // namespace stridor::model
