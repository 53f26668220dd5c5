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

#include "stridor/base/error.hpp"
#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double is_loose = 1e-13;  // [1] of the diagonal: a pivot of the interior that is rounding

/// Rows in their new order: where each old row went.
struct Parting {
    std::vector<Index> boundary;
    std::vector<Index> interior;
    std::vector<Index> place;  // within its own list, shape [row]
    std::vector<char> is_boundary;
};

Parting part_rows(const ElasticPart& part, const std::vector<Index>& boundary) {
    if (boundary.empty())
        base::refuse("the boundary is empty", "a reduced part rubs, is driven or held at its boundary",
                     "Name a node set or nodes.");
    Parting parting{boundary, {}, std::vector<Index>(part.labels.size()), std::vector<char>(part.labels.size(), 0)};
    for (std::size_t k = 0; k < boundary.size(); ++k) {
        const auto row = static_cast<std::size_t>(boundary[k]);
        if (parting.is_boundary[row] != 0)
            base::refuse(fmt::format("row {} stands twice in the boundary", describe(part.labels[row])),
                         "each of its rows is a coordinate", "");
        parting.is_boundary[row] = 1;
        parting.place[row] = static_cast<Index>(k);
    }
    for (std::size_t row = 0; row < part.labels.size(); ++row) {
        if (parting.is_boundary[row] != 0) continue;
        parting.place[row] = static_cast<Index>(parting.interior.size());
        parting.interior.push_back(static_cast<Index>(row));
    }
    return parting;
}

// the block of a matrix between boundary (1) or interior (0) rows and columns
SparseMatrix block(const SparseMatrix& matrix, const Parting& parting, int rows, int columns) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index column = 0; column < matrix.outerSize(); ++column) {
        if (parting.is_boundary[static_cast<std::size_t>(column)] != columns) continue;
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (parting.is_boundary[static_cast<std::size_t>(entry.row())] == rows)
                entries.emplace_back(parting.place[static_cast<std::size_t>(entry.row())],
                                     parting.place[static_cast<std::size_t>(column)], entry.value());
    }
    const auto size = [&](int kind) {
        return static_cast<Index>(kind == 1 ? parting.boundary.size() : parting.interior.size());
    };
    SparseMatrix found(size(rows), size(columns));
    found.setFromTriplets(entries.begin(), entries.end());
    return found;
}

/// Psi and Phi.
struct Basis {
    MatrixXd constraint;  // [1] shape [interior][boundary]
    Modes modes;
};

Basis basis_of(const ElasticPart& part, const Parting& parting, const ReductionRequest& request) {
    const SparseMatrix inner_stiffness = block(part.stiffness, parting, 0, 0);
    const auto boundary = static_cast<Index>(parting.boundary.size());
    if (inner_stiffness.rows() == 0) return {MatrixXd(0, boundary), {VectorXd(0), MatrixXd(0, 0)}};
    const SparseMatrix inner_mass = block(part.mass, parting, 0, 0);
    const SparseFactor factor(inner_stiffness, inner_mass, 0.0);
    if (!factor.is_whole() || factor.weakest_pivot() < is_loose || factor.negative_pivots() > 0)
        base::refuse("the boundary does not hold the part", "with the boundary held still the interior can move freely",
                     "Add nodes to the boundary, or supports to the model.");
    const Index modes = request.below > 0.0 ? modes_below(inner_stiffness, inner_mass, request.below) : request.modes;
    return {factor.solve(MatrixXd(block(part.stiffness, parting, 0, 1))) * -1.0,
            lowest_modes(inner_stiffness, inner_mass, modes, factor, ModeCount::counted)};
}

// T' A T of a symmetric matrix
MatrixXd projected(const SparseMatrix& matrix, const Parting& parting, const Basis& basis) {
    const auto boundary = static_cast<Index>(parting.boundary.size());
    const Index modes = basis.modes.squared.size();
    const SparseMatrix across = block(matrix, parting, 1, 0);  // b, i
    const SparseMatrix inner = block(matrix, parting, 0, 0);
    const MatrixXd moved = inner * basis.constraint;
    MatrixXd all(boundary + modes, boundary + modes);
    const MatrixXd mixed = across * basis.constraint;
    all.topLeftCorner(boundary, boundary) =
        MatrixXd(block(matrix, parting, 1, 1)) + mixed + mixed.transpose() + basis.constraint.transpose() * moved;
    all.topRightCorner(boundary, modes) =
        (across + SparseMatrix(moved.transpose().sparseView(0.0, 0.0))) * basis.modes.shapes;
    all.bottomLeftCorner(modes, boundary) = all.topRightCorner(boundary, modes).transpose();
    all.bottomRightCorner(modes, modes) = basis.modes.shapes.transpose() * (inner * basis.modes.shapes);
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

void recover(Reduction& reduction, const ElasticPart& part, const Parting& parting, const Basis& basis,
             const std::vector<Index>& rows) {
    reduction.recovery = MatrixXd::Zero(static_cast<Index>(rows.size()), rows_of(reduction.part));
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = static_cast<std::size_t>(rows[k]);
        reduction.recovered.push_back(part.labels[row]);
        auto into = reduction.recovery.row(static_cast<Index>(k));
        if (parting.is_boundary[row] != 0)
            into[parting.place[row]] = 1.0;
        else
            into << basis.constraint.row(parting.place[row]), basis.modes.shapes.row(parting.place[row]);
    }
}

// positions and sets of what the reduced part still names
void keep_geometry(ElasticPart& reduced, const ElasticPart& part, const std::vector<RowLabel>& recovered) {
    const auto keep = [&](const RowLabel& label) {
        if (const auto found = part.positions.find(label.node); found != part.positions.end())
            reduced.positions.insert(*found);
    };
    std::for_each(reduced.labels.begin(), reduced.labels.end(), keep);
    std::for_each(recovered.begin(), recovered.end(), keep);
    for (const NodeSet& set : part.sets) {
        NodeSet kept{set.name, {}};
        for (const std::string& node : set.nodes)
            if (std::any_of(reduced.labels.begin(), reduced.labels.end(),
                            [&](const RowLabel& label) { return label.node == node; }))
                kept.nodes.push_back(node);
        if (!kept.nodes.empty()) reduced.sets.push_back(std::move(kept));
    }
}

}  // namespace

Reduction craig_bampton(const ElasticPart& part, const ReductionRequest& request) {
    const Parting parting = part_rows(part, request.boundary);
    const Basis basis = basis_of(part, parting, request);
    Reduction reduction;
    reduction.boundary_rows = static_cast<Index>(parting.boundary.size());
    reduction.inertia = request.inertia;
    for (const Index row : parting.boundary)
        reduction.part.labels.push_back(part.labels[static_cast<std::size_t>(row)]);
    for (Index mode = 0; mode < basis.modes.squared.size(); ++mode) {
        reduction.part.labels.push_back({"mode " + std::to_string(mode + 1), 0});
        reduction.mode_frequencies.push_back(frequency_of(basis.modes.squared[mode]));
    }
    const Index modes = basis.modes.squared.size();
    const SparseMatrix across = block(part.stiffness, parting, 1, 0);
    MatrixXd stiffness = MatrixXd::Zero(reduction.boundary_rows + modes, reduction.boundary_rows + modes);
    stiffness.topLeftCorner(reduction.boundary_rows, reduction.boundary_rows) =
        MatrixXd(block(part.stiffness, parting, 1, 1)) + across * basis.constraint;
    stiffness.bottomRightCorner(modes, modes).diagonal() = basis.modes.squared;
    reduction.part.stiffness = MatrixXd(0.5 * (stiffness + stiffness.transpose())).sparseView(0.0, 0.0);
    MatrixXd mass = projected(part.mass, parting, basis);
    mass.bottomRightCorner(modes, modes).setIdentity();
    if (request.inertia == BoundaryInertia::lumped) lump(mass, reduction.boundary_rows, reduction.part.labels);
    reduction.part.mass = mass.sparseView(0.0, 0.0);
    if (part.damping.rows() != 0) reduction.part.damping = projected(part.damping, parting, basis).sparseView(0.0, 0.0);
    recover(reduction, part, parting, basis, request.recovered);
    keep_geometry(reduction.part, part, reduction.recovered);
    return reduction;
}

}  // namespace stridor::reduction
