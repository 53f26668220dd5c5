#pragma once

#include "stridor/base/error.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

/// Can a structure with several contacts be believed, before anything is simulated? W = [n t]' M^-1 [n t] says what an
/// impulse at one contact does to the velocities of all.
namespace stridor::model {

/// W [1/kg], rows and columns n0, t0, n1, t1, ...
Eigen::MatrixXd contact_compliance(const Structure& structure);

/// How much of an impulse at one contact another one feels.
struct SharedInertia {
    double share = 0.0;  // [1] largest |W_ab| / sqrt(W_aa W_bb), a of one contact and b of another
    std::size_t first = 0;
    std::size_t second = 0;  // the two contacts
};

/// The two contacts that inertia couples most; a share of 0 for less than two.
SharedInertia most_shared_inertia(const Eigen::MatrixXd& compliance);

/// How far a contact is from Painleve's configuration, in which friction of a slip presses it together more than its
/// normal force parts it.
struct NormalGiving {
    double share = 1.0;  // [1] least (W_nn + ratio W_nt) / W_nn over both ways to slip; at most 0: Painleve
    std::size_t contact = 0;
    double ratio = 0.0;  // [1] T/N of that slip
};

/// The contact that gives way least along its normal; the structure must have one at least.
NormalGiving least_normal_giving(const Structure& structure, const Eigen::MatrixXd& compliance);

/// What makes a structure hard to believe, in words, with what to do; nothing if it is sound:
///
/// - contacts that touch different degrees of freedom and yet share more than a tenth of their inertia: consistent
///   mass, or modes that were cut off. Each impact throws the neighbours off, and no time step is small enough. A rigid
///   body on which several contacts rub is no such case: they share its degree of freedom;
/// - a configuration of Painleve; a normal or tangent that moves no mass;
/// - modes of negative stiffness: the structure moves away by itself.
///
/// `names` are of the contacts, shape [contact].
std::vector<base::Problem> doubts(const Structure& structure, const std::vector<std::string>& names);

}  // namespace stridor::model
