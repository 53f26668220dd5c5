#pragma once

#include "stridor/base/error.hpp"
#include "stridor/reduction/part.hpp"

#include <optional>
#include <vector>

namespace stridor::reduction {

/// The inertia of a part's contact rows in an impact: W = (M^-1)_bb.
struct PartContacts {
    Eigen::Index rows = 0;
    double shared_inertia = 0.0;  // [1] largest |W_ab| / sqrt(W_aa W_bb), a and b of different nodes
    RowLabel first{}, second{};   // those rows
    // [1] friction from which a node is a configuration of Painleve, W_nn <= mu |W_nt|; infinite if normal and
    // tangential motion are not coupled; `std::nullopt` without the component of the normal
    std::optional<double> painleve_friction{};
    RowLabel weakest{};  // the normal of that node
};

/// Returns the inertia of these rows, or `std::nullopt` if some motion has no mass, since W is infinite then. `normal`
/// is the component of the contacts' normal (1 to 3), 0 if it is not known.
std::optional<PartContacts> part_contacts(const ElasticPart& part, const std::vector<Eigen::Index>& rows, int normal,
                                          LinearSolver by = LinearSolver::eigen);

/// Returns the reasons to doubt contacts of a part, in words, each with a remedy: more than a tenth of shared inertia,
/// and a configuration of Painleve below this friction coefficient [1].
std::vector<base::Problem> doubts(const PartContacts& contacts, double friction);

}  // namespace stridor::reduction
