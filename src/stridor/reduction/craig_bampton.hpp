#pragma once

#include "stridor/reduction/part.hpp"

#include <vector>

namespace stridor::reduction {

/// The inertia that a contact meets in an impact: S = M_bb - M_bq M_qb, the mass of the boundary behind which the modes
/// do not follow at once. Its inverse is W of the contacts.
enum class BoundaryInertia {
    consistent,  // as reduced: an impact at one node throws its neighbours
    lumped,      // S diagonal, the mass of each direction kept: an impact at one node leaves its neighbours alone
};

struct ReductionRequest {
    std::vector<Eigen::Index> boundary{};  // rows that stay as they are: contacts, drives, loads
    Eigen::Index modes = 0;                // [1] fixed-interface modes kept; fewer where there are no more
    double below = 0.0;  // [Hz] where positive: all fixed-interface modes below it, whatever `modes` says
    BoundaryInertia inertia = BoundaryInertia::lumped;
    std::vector<Eigen::Index> recovered{};  // further rows whose motion is wanted
};

/// A part in the coordinates of Craig and Bampton: first the boundary's rows, labelled as before, then "mode 1", "mode
/// 2" and so on.
struct Reduction {
    ElasticPart part;
    Eigen::Index boundary_rows = 0;  // [1] the first of its rows
    BoundaryInertia inertia = BoundaryInertia::lumped;
    std::vector<double> mode_frequencies;  // [Hz] of the fixed-interface modes, rising
    std::vector<RowLabel> recovered;       // shape [recovered]
    Eigen::MatrixXd recovery;              // [1] u of those rows = recovery * coordinates; shape [recovered][row]
};

/// Reduces a sound part in SI (`expect_sound`, `in_si`) to a boundary and the lowest modes with that boundary held
/// (Craig and Bampton, AIAA Journal 6, 1968, 1313).
///
/// Statics of the boundary are exact. The modes have unit mass; a damping is projected. Throws `Error` (input) for a
/// boundary that is empty, names a row twice, or does not hold the part still (a mechanism would remain inside), and
/// `Error` (numerical) where its modes are not found.
Reduction craig_bampton(const ElasticPart& part, const ReductionRequest& request);

}  // namespace stridor::reduction
