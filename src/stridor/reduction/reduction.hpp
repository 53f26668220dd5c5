#pragma once

#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/part.hpp"

#include <string_view>
#include <vector>

namespace stridor::reduction {

/// The inertia that a contact meets in an impact: S = M_bb - M_bq M_qb, the mass of the boundary without the modes,
/// which do not follow at once. Its inverse is W of the contacts.
enum class BoundaryInertia {
    consistent,  // as reduced: an impact at one node throws its neighbours
    lumped,      // S diagonal, the mass of each direction kept: an impact at one node leaves its neighbours alone
    massless,    // none: the boundary follows at once (MacNeal)
};

/// The modes beside the boundary.
enum class ReductionMethod {
    craig_bampton,  // with the boundary held; the boundary has a mass
    macneal,        // with the boundary free; the boundary has stiffness alone
};

/// Returns "lumped", "consistent" or "massless".
constexpr std::string_view name_of(BoundaryInertia inertia) {
    if (inertia == BoundaryInertia::massless) return "massless";
    return inertia == BoundaryInertia::lumped ? "lumped" : "consistent";
}

/// Returns "Craig-Bampton" or "MacNeal".
constexpr std::string_view name_of(ReductionMethod method) {
    return method == ReductionMethod::macneal ? "MacNeal" : "Craig-Bampton";
}

struct ReductionRequest {
    std::vector<Eigen::Index> boundary{};  // rows that stay as they are: contacts, drives, loads
    Eigen::Index modes = 0;                // [1] modes kept; fewer if there are no more
    double below = 0.0;                    // [Hz] if positive: all modes below it, whatever `modes` says
    BoundaryInertia inertia = BoundaryInertia::lumped;
    std::vector<Eigen::Index> recovered{};  // further rows with a recovered motion
};

/// A reduced part in its coordinates: first the boundary's rows, labelled as before, then "mode 1", "mode
/// 2" and so on.
struct Reduction {
    ElasticPart part;
    Eigen::Index boundary_rows = 0;  // [1] the first of its rows
    ReductionMethod method = ReductionMethod::craig_bampton;
    BoundaryInertia inertia = BoundaryInertia::lumped;
    LinearSolver solver = LinearSolver::eigen;  // of the full part
    std::vector<double> mode_frequencies;       // [Hz] of the modes, rising
    std::vector<RowLabel> recovered;            // shape [recovered]
    Eigen::MatrixXd recovery;                   // [1] u of those rows = recovery * coordinates; shape [recovered][row]
};

/// Throws `Error` (numerical) for a reduction whose matrices leave double precision.
void expect_finite(const Reduction& reduction);

/// Returns a reduced part of these modes with its labels, places and sets, and no matrices yet.
Reduction opened_reduction(const ElasticPart& part, const ReductionRequest& request, const Modes& modes);

}  // namespace stridor::reduction
