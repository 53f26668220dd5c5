#include "stridor/reduction/part_contacts.hpp"

#include "stridor/base/text.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double massless_pivot = 1e-13;  // [1] of the diagonal
// [1] neighbours of consistent mass share 0.27, of lumped mass nothing
constexpr double most_believed_share = 0.1;

// N and T of one node meet in W: the friction from which T presses it together more than N parts it
double painleve_friction(const MatrixXd& w, const std::vector<RowLabel>& labels, Index normal) {
    double across = 0.0;
    for (Index t = 0; t < w.rows(); ++t) {
        const RowLabel& label = labels[static_cast<std::size_t>(t)];
        const bool is_tangent = t != normal && label.node == labels[static_cast<std::size_t>(normal)].node &&
                                label.component >= 1 && label.component <= 3;
        if (is_tangent) across += w(normal, t) * w(normal, t);
    }
    return across > 0.0 ? w(normal, normal) / std::sqrt(across) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<PartContacts> part_contacts(const ElasticPart& part, const std::vector<Index>& rows, int normal,
                                          LinearSolver by) {
    const SparseMatrix none(part.mass.rows(), part.mass.cols());
    const SparseFactor factor(part.mass, none, 0.0, by);
    if (!factor.is_whole() || factor.weakest_pivot() < massless_pivot) return std::nullopt;
    const auto count = static_cast<Index>(rows.size());
    MatrixXd pushes = MatrixXd::Zero(rows_of(part), count);
    std::vector<RowLabel> labels;
    for (Index k = 0; k < count; ++k) {
        pushes(rows[static_cast<std::size_t>(k)], k) = 1.0;
        labels.push_back(part.labels[static_cast<std::size_t>(rows[static_cast<std::size_t>(k)])]);
    }
    const MatrixXd w = pushes.transpose() * factor.solve(pushes);
    PartContacts contacts{.rows = count};
    for (Index a = 0; a < count; ++a)
        for (Index b = a + 1; b < count; ++b) {
            const RowLabel& first = labels[static_cast<std::size_t>(a)];
            const RowLabel& second = labels[static_cast<std::size_t>(b)];
            const double share = std::abs(w(a, b)) / std::sqrt(w(a, a) * w(b, b));
            if (first.node == second.node || !(share > contacts.shared_inertia)) continue;
            contacts.shared_inertia = share;
            contacts.first = first;
            contacts.second = second;
        }
    for (Index k = 0; k < count; ++k) {
        if (normal == 0 || labels[static_cast<std::size_t>(k)].component != normal) continue;
        const double friction = painleve_friction(w, labels, k);
        if (contacts.painleve_friction && friction >= *contacts.painleve_friction) continue;
        contacts.painleve_friction = friction;
        contacts.weakest = labels[static_cast<std::size_t>(k)];
    }
    return contacts;
}

std::vector<base::Problem> doubts(const PartContacts& contacts, double friction) {
    std::vector<base::Problem> found;
    if (contacts.shared_inertia > most_believed_share)
        found.push_back({fmt::format("inertia couples {} and {} by {:.2g} of their own", describe(contacts.first),
                                     describe(contacts.second), contacts.shared_inertia),
                         "an impact at one throws the other off, again and again: an artefact of consistent mass or of "
                         "cut modes, in which no time step is small enough",
                         "Reduce the part with --inertia lumped, which is the default."});
    if (contacts.painleve_friction && *contacts.painleve_friction <= friction)
        found.push_back({fmt::format("{} is a configuration of Painleve from a friction of {:.3g} on",
                                     describe(contacts.weakest), *contacts.painleve_friction),
                         fmt::format("a friction of {} presses it together more than its normal force parts it",
                                     base::shortest(friction)),
                         "Use less friction, or uncouple normal and tangential motion."});
    return found;
}

}  // namespace stridor::reduction
