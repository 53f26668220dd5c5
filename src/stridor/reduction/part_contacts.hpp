#pragma once

#include "stridor/base/error.hpp"
#include "stridor/reduction/part.hpp"

#include <optional>
#include <vector>

namespace stridor::reduction {

/// What the rows of a part at which contacts are to be meet in an impact: W = (M^-1)_bb.
struct PartContacts {
    Eigen::Index rows = 0;
    double shared_inertia = 0.0;  // [1] largest |W_ab| / sqrt(W_aa W_bb), a and b of different nodes
    RowLabel first{}, second{};   // those rows
    // [1] friction from which a node is a configuration of Painleve, W_nn <= mu |W_nt|; infinite where normal and
    // tangential motion do not meet; none without the component of the normal
    std::optional<double> painleve_friction{};
    RowLabel weakest{};  // the normal of that node
};

/// Nothing where some motion has no mass: W has no end then. `normal` is the component of the contacts' normal (1 to
/// 3), 0 if it is not known.
std::optional<PartContacts> part_contacts(const ElasticPart& part, const std::vector<Eigen::Index>& rows, int normal,
                                          LinearSolver by = LinearSolver::eigen);

/// What makes contacts of a part hard to believe, in words, with what to do: more than a tenth of shared inertia, and a
/// configuration of Painleve below this friction coefficient [1].
std::vector<base::Problem> doubts(const PartContacts& contacts, double friction);

}  // namespace stridor::reduction
