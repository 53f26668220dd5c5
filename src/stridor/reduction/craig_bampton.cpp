// Craig-Bampton: with the rows parted into the boundary b and the interior i,
//
//     u_b = b,   u_i = Psi b + Phi q,   Psi = -K_ii^-1 K_ib,   K_ii Phi = M_ii Phi Lambda,   Phi' M_ii Phi = 1
//
//     K_r = | K_bb + K_bi Psi    0      |      M_r = | T_b' M T_b            (M_bi + Psi' M_ii) Phi |
//           | 0                  Lambda |            | sym.                  1                      |
//
// K_r couples boundary and modes nowhere, M_r does. The mass that an impact meets is S = M_rbb - M_rbq M_rqb, since
// q'' answers at once: S^-1 is the boundary's part of M_r^-1. Truncation and consistent masses fill S. Lumped inertia
// puts in its place the diagonal with the same sum per direction, in the proportion of S's own (Hinton, Rock,
// Zienkiewicz, 1976): M_rbb = D + M_rbq M_rqb. M_rbq stays: it alone couples boundary and modes.

#include "stridor/reduction/craig_bampton.hpp"

#include "stridor/reduction/lowest_modes.hpp"

#include <array>
#include <string>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Modes held_modes(const CondensedPart& condensed, const ReductionRequest& request) {
    const SparseMatrix& stiffness = condensed.inner_stiffness();
    const SparseMatrix& mass = condensed.inner_mass();
    if (stiffness.rows() == 0) return {VectorXd(0), MatrixXd(0, 0)};
    const Index modes =
        request.below > 0.0 ? modes_below(stiffness, mass, request.below, condensed.linear_solver()) : request.modes;
    return lowest_modes(stiffness, mass, modes, condensed.inner_solver(), condensed.linear_solver());
}

// T' A T of a symmetric matrix; only a triangle of the large product is worked out
MatrixXd projected(const SparseMatrix& matrix, const CondensedPart& condensed, const Modes& modes) {
    const Parting& parting = condensed.parting();
    const MatrixXd& constraint = condensed.constraint();
    const Index boundary = constraint.cols();
    const Index kept = modes.squared.size();
    const SparseMatrix across = block(matrix, parting, RowKind::boundary, RowKind::interior);
    const SparseMatrix inner = block(matrix, parting, RowKind::interior, RowKind::interior);
    const MatrixXd moved = inner * constraint;
    const MatrixXd mixed = across * constraint;
    MatrixXd condensed_block = block(matrix, parting, RowKind::boundary, RowKind::boundary);
    condensed_block += mixed + mixed.transpose();
    condensed_block.triangularView<Eigen::Lower>() += constraint.transpose() * moved;
    MatrixXd all(boundary + kept, boundary + kept);
    all.topLeftCorner(boundary, boundary) = condensed_block.selfadjointView<Eigen::Lower>();
    all.topRightCorner(boundary, kept) = across * modes.shapes + moved.transpose() * modes.shapes;
    all.bottomLeftCorner(kept, boundary) = all.topRightCorner(boundary, kept).transpose();
    all.bottomRightCorner(kept, kept) = modes.shapes.transpose() * (inner * modes.shapes);
    return 0.5 * (all + all.transpose());
}

// the diagonal in the proportion of S's, with its sum per direction of motion
VectorXd lumped(const MatrixXd& inertia, const std::vector<RowLabel>& labels) {
    VectorXd diagonal = inertia.diagonal();
    for (int component = 1; component <= 6; ++component) {
        VectorXd motion = VectorXd::Zero(diagonal.size());
        for (Index row = 0; row < motion.size(); ++row)
            if (labels[static_cast<std::size_t>(row)].component == component) motion[row] = 1.0;
        const double share = motion.dot(diagonal);
        const double total = motion.dot(inertia * motion);
        if (!(share > 0.0) || !(total > 0.0)) continue;
        diagonal = (motion.array() > 0.0).select(diagonal * (total / share), diagonal);
    }
    return diagonal;
}

void lump(MatrixXd& mass, Index boundary, const std::vector<RowLabel>& labels) {
    const Index modes = mass.rows() - boundary;
    const MatrixXd across = mass.topRightCorner(boundary, modes);
    const MatrixXd follows = across * across.transpose();
    const MatrixXd inertia = mass.topLeftCorner(boundary, boundary) - follows;
    mass.topLeftCorner(boundary, boundary) = follows;
    mass.topLeftCorner(boundary, boundary).diagonal() += lumped(inertia, labels);
}

void recover(Reduction& reduction, const CondensedPart& condensed, const Modes& modes, const std::vector<Index>& rows) {
    const Parting& parting = condensed.parting();
    reduction.recovery = MatrixXd::Zero(static_cast<Index>(rows.size()), rows_of(reduction.part));
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = static_cast<std::size_t>(rows[k]);
        auto into = reduction.recovery.row(static_cast<Index>(k));
        if (parting.is_boundary[row] != 0)
            into[parting.place[row]] = 1.0;
        else
            into << condensed.constraint().row(parting.place[row]), modes.shapes.row(parting.place[row]);
    }
}

}  // namespace

Reduction craig_bampton(const CondensedPart& condensed, const ReductionRequest& request) {
    const ElasticPart& part = condensed.part();
    const Modes modes = held_modes(condensed, request);
    Reduction reduction = opened_reduction(part, request, modes);
    reduction.method = ReductionMethod::craig_bampton;
    reduction.solver = condensed.linear_solver();
    reduction.inertia = request.inertia;
    const Index boundary = reduction.boundary_rows;
    const Index kept = modes.squared.size();
    MatrixXd stiffness = MatrixXd::Zero(boundary + kept, boundary + kept);
    stiffness.topLeftCorner(boundary, boundary) = condensed.stiffness();
    stiffness.bottomRightCorner(kept, kept).diagonal() = modes.squared;
    reduction.part.stiffness = stiffness.sparseView(0.0, 0.0);
    MatrixXd mass = projected(part.mass, condensed, modes);
    mass.bottomRightCorner(kept, kept).setIdentity();
    if (request.inertia == BoundaryInertia::lumped) lump(mass, boundary, reduction.part.labels);
    reduction.part.mass = mass.sparseView(0.0, 0.0);
    if (part.damping.rows() != 0)
        reduction.part.damping = projected(part.damping, condensed, modes).sparseView(0.0, 0.0);
    recover(reduction, condensed, modes, request.recovered);
    expect_finite(reduction);
    return reduction;
}

Reduction craig_bampton(const ElasticPart& part, const ReductionRequest& request) {
    return craig_bampton(CondensedPart(part, request.boundary), request);
}

}  // namespace stridor::reduction
