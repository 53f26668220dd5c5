#include "stridor/model/contact/contact_compliance.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::model {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [1] neighbours of consistent mass share 0.27, of lumped mass nothing; a cut of modes leaves 0.05 to 0.3
constexpr double most_believed_share = 0.1;
constexpr double stiffness_rounding = 1e-9;  // [1] of the largest omega²: a rigid-body mode

bool touch_one_degree_of_freedom(const ContactPoint& a, const ContactPoint& b) {
    const VectorXd first = a.normal.cwiseAbs() + a.tangent.cwiseAbs();
    const VectorXd second = b.normal.cwiseAbs() + b.tangent.cwiseAbs();
    return (first.array() * second.array() != 0.0).any();
}

// of two contacts
double share_between(const MatrixXd& w, Index a, Index b) {
    double share = 0.0;
    for (Index i = 2 * a; i < 2 * a + 2; ++i)
        for (Index j = 2 * b; j < 2 * b + 2; ++j)
            if (w(i, i) > 0.0 && w(j, j) > 0.0)
                share = std::max(share, std::abs(w(i, j)) / std::sqrt(w(i, i) * w(j, j)));
    return share;
}

template <typename Counts>
SharedInertia most_shared_where(const MatrixXd& compliance, const Counts& counts) {
    SharedInertia most;
    for (Index a = 0; 2 * a < compliance.rows(); ++a)
        for (Index b = a + 1; 2 * b < compliance.rows(); ++b) {
            const double share = share_between(compliance, a, b);
            if (share > most.share && counts(static_cast<std::size_t>(a), static_cast<std::size_t>(b)))
                most = {share, static_cast<std::size_t>(a), static_cast<std::size_t>(b)};
        }
    return most;
}

// modes of negative stiffness
Index modes_that_run_away(const Structure& structure) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(linearised_at_rest(structure).stiffness,
                                                                    structure.mass, Eigen::EigenvaluesOnly);
    const double most = solver.eigenvalues().cwiseAbs().maxCoeff();
    return (solver.eigenvalues().array() < -stiffness_rounding * most).count();
}

}  // namespace

MatrixXd contact_compliance(const Structure& structure) {
    const auto p = static_cast<Index>(structure.contacts.size());
    MatrixXd rows(dofs_of(structure), 2 * p);
    for (Index k = 0; k < p; ++k) {
        rows.col(2 * k) = structure.contacts[static_cast<std::size_t>(k)].normal;
        rows.col(2 * k + 1) = structure.contacts[static_cast<std::size_t>(k)].tangent;
    }
    return rows.transpose() * structure.mass.ldlt().solve(rows);
}

SharedInertia most_shared_inertia(const MatrixXd& compliance) {
    return most_shared_where(compliance, [](std::size_t, std::size_t) { return true; });
}

NormalGiving least_normal_giving(const Structure& structure, const MatrixXd& compliance) {
    NormalGiving least;
    for (std::size_t k = 0; k < structure.contacts.size(); ++k)
        for (const Slip way : slips) {
            const auto n = static_cast<Index>(2 * k);
            const double ratio = slip_ratio(structure.contacts[k].friction, way);
            const double share = 1.0 + ratio * compliance(n, n + 1) / compliance(n, n);
            if (share < least.share) least = {share, k, ratio};
        }
    return least;
}

std::vector<base::Problem> doubts(const Structure& structure, const std::vector<std::string>& names) {
    std::vector<base::Problem> found;
    const MatrixXd w = contact_compliance(structure);
    for (std::size_t k = 0; k < structure.contacts.size(); ++k)
        for (const auto& [row, direction] : {std::pair(2 * k, "normal"), std::pair(2 * k + 1, "tangent")})
            if (!(w(static_cast<Index>(row), static_cast<Index>(row)) > 0.0))
                found.push_back({fmt::format("the {} of {} moves no mass", direction, names[k]),
                                 "no velocity answers an impulse there", "Give it a direction of the structure."});
    if (!found.empty()) return found;
    const SharedInertia shared = most_shared_where(w, [&](std::size_t a, std::size_t b) {
        return !touch_one_degree_of_freedom(structure.contacts[a], structure.contacts[b]);
    });
    if (shared.share > most_believed_share)
        found.push_back({fmt::format("inertia couples {} and {} by {:.2g} of their own", names[shared.first],
                                     names[shared.second], shared.share),
                         "an impact at one throws the other off, again and again: an artefact of consistent mass or of "
                         "cut modes, in which no time step is small enough",
                         "Lump the inertia of the contacts: stridor structure reduce --inertia lumped."});
    const NormalGiving giving = least_normal_giving(structure, w);
    if (!(giving.share > 0.0))
        found.push_back({fmt::format("{} is a configuration of Painleve at mu_d = {}", names[giving.contact],
                                     base::shortest(std::abs(giving.ratio))),
                         fmt::format("friction presses it together by {:.3g} of what its normal force parts it",
                                     1.0 - giving.share),
                         "Use less friction there, or uncouple normal and tangential motion."});
    if (const Index modes = modes_that_run_away(structure); modes > 0)
        found.push_back({fmt::format("{} mode{} of the structure {} negative stiffness", modes, modes == 1 ? "" : "s",
                                     modes == 1 ? "has" : "have"),
                         "it moves away by itself, without friction",
                         "Check signs and units of the stiffness matrix."});
    return found;
}

}  // namespace stridor::model
