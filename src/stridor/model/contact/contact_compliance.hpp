#pragma once

#include "stridor/base/error.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

/// Checks before a simulation whether a structure with several contacts is believable. W = [n t]' M^-1 [n t] says how
/// an impulse at one contact changes the velocities of all.
namespace stridor::model {

/// Returns W [1/kg], rows and columns n0, t0, n1, t1, ...
Eigen::MatrixXd contact_compliance(const Structure& structure);

/// How strongly an impulse at one contact moves another contact.
struct SharedInertia {
    double share = 0.0;  // [1] largest |W_ab| / sqrt(W_aa W_bb), a of one contact and b of another
    std::size_t first = 0;
    std::size_t second = 0;  // the two contacts
};

/// Returns the two contacts that inertia couples most; a share of 0 if there are fewer than two contacts.
SharedInertia most_shared_inertia(const Eigen::MatrixXd& compliance);

/// How far a contact is from Painleve's configuration, in which the friction of a slip presses the contact together
/// more than its normal force parts it.
struct NormalGiving {
    double share = 1.0;  // [1] least (W_nn + ratio W_nt) / W_nn over both ways to slip; at most 0: Painleve
    std::size_t contact = 0;
    double ratio = 0.0;  // [1] T/N of that slip
};

/// Returns the contact that yields least along its normal. The structure must have at least one.
NormalGiving least_normal_giving(const Structure& structure, const Eigen::MatrixXd& compliance);

/// Returns the reasons to doubt a structure, in words, each with a remedy; an empty list if it is sound:
///
/// - contacts that touch different degrees of freedom and yet share more than a tenth of their inertia: consistent
///   mass, or modes that were cut off. Each impact throws the neighbours off, and no time step is small enough. A rigid
///   body on which several contacts rub is not such a case: they share its degree of freedom;
/// - a configuration of Painleve; a normal or tangent that moves no mass;
/// - modes of negative stiffness: the structure moves away by itself.
///
/// `names` are the contacts' names, shape [contact].
std::vector<base::Problem> doubts(const Structure& structure, const std::vector<std::string>& names);

}  // namespace stridor::model
