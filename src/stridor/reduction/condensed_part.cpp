#include "stridor/reduction/condensed_part.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double is_loose = 1e-13;       // [1] of the diagonal: a pivot of the interior that is rounding
constexpr double free_boundary = 1e-10;  // [1] of the diagonal: a pivot of S that lets the part move

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

/// S with some rows held, factorised with a unit diagonal, so that rotations weigh as much as displacements.
struct HeldBoundary {
    std::vector<Index> free;  // places in the boundary
    VectorXd scale;           // [1] shape [free]
    Eigen::LDLT<MatrixXd> factor;

    VectorXd solve(const VectorXd& load) const {
        return scale.cwiseProduct(factor.solve(scale.cwiseProduct(load).eval()));
    }
};

// nothing where it can move freely
std::shared_ptr<const HeldBoundary> held_boundary(const MatrixXd& stiffness, const std::vector<Index>& held) {
    auto found = std::make_shared<HeldBoundary>();
    for (Index row = 0; row < stiffness.rows(); ++row)
        if (std::find(held.begin(), held.end(), row) == held.end()) found->free.push_back(row);
    const auto size = static_cast<Index>(found->free.size());
    if (size == 0) return found;
    MatrixXd scaled = stiffness(found->free, found->free);
    if (!(scaled.diagonal().minCoeff() > 0.0)) return nullptr;
    found->scale = scaled.diagonal().cwiseSqrt().cwiseInverse();
    scaled = found->scale.asDiagonal() * scaled * found->scale.asDiagonal();
    found->factor.compute(scaled);
    if (found->factor.info() != Eigen::Success || !(found->factor.vectorD().minCoeff() > free_boundary)) return nullptr;
    return found;
}

}  // namespace

SparseMatrix block(const SparseMatrix& matrix, const Parting& parting, RowKind rows, RowKind columns) {
    const auto is_of = [&](Index row, RowKind kind) {
        return (parting.is_boundary[static_cast<std::size_t>(row)] != 0) == (kind == RowKind::boundary);
    };
    const auto place = [&](Index row) { return parting.place[static_cast<std::size_t>(row)]; };
    std::vector<Eigen::Triplet<double>> entries;
    for (Index column = 0; column < matrix.outerSize(); ++column) {
        if (!is_of(column, columns)) continue;
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (is_of(entry.row(), rows)) entries.emplace_back(place(entry.row()), place(column), entry.value());
    }
    const auto size = [&](RowKind kind) {
        return static_cast<Index>(kind == RowKind::boundary ? parting.boundary.size() : parting.interior.size());
    };
    SparseMatrix found(size(rows), size(columns));
    found.setFromTriplets(entries.begin(), entries.end());
    return found;
}

CondensedPart::CondensedPart(const ElasticPart& part, const std::vector<Index>& boundary, LinearSolver by)
    : part_(part),
      linear_solver_(by),
      parting_(part_rows(part, boundary)),
      inner_stiffness_(block(part.stiffness, parting_, RowKind::interior, RowKind::interior)),
      inner_mass_(block(part.mass, parting_, RowKind::interior, RowKind::interior)),
      stiffness_(block(part.stiffness, parting_, RowKind::boundary, RowKind::boundary)) {
    expect_stiff(part, 0.0);
    constraint_.resize(inner_stiffness_.rows(), stiffness_.rows());
    if (constraint_.rows() == 0) return;
    factor_ = std::make_unique<SparseFactor>(inner_stiffness_, inner_mass_, 0.0, by);
    if (!factor_->is_whole() || factor_->weakest_pivot() < is_loose || factor_->negative_pivots() > 0)
        base::refuse("the boundary does not hold the part", "with the boundary held still the interior can move freely",
                     "Add nodes to the boundary, or supports to the model.");
    const SparseMatrix across = block(part.stiffness, parting_, RowKind::interior, RowKind::boundary);
    // some columns at a time: a large part's fill the memory
    constexpr Index at_once = 64;
    for (Index from = 0; from < constraint_.cols(); from += at_once) {
        const Index columns = std::min(at_once, constraint_.cols() - from);
        constraint_.middleCols(from, columns) = -factor_->solve(MatrixXd(across.middleCols(from, columns)));
    }
    stiffness_ += across.transpose() * constraint_;
    stiffness_ = (0.5 * (stiffness_ + stiffness_.transpose())).eval();
}

StaticSolver CondensedPart::inner_solver() const {
    return [this](const VectorXd& load) { return VectorXd(factor_->solve(load)); };
}

std::optional<StaticSolver> CondensedPart::solver(const std::vector<Index>& held) const {
    const auto boundary = held_boundary(stiffness_, held);
    if (!boundary) return std::nullopt;
    // where each row stands among those that are not held
    std::vector<char> is_held(part_.labels.size(), 0);
    for (const Index place : held)
        is_held[static_cast<std::size_t>(parting_.boundary[static_cast<std::size_t>(place)])] = 1;
    std::vector<Index> place(part_.labels.size());
    Index rows = 0;
    for (std::size_t row = 0; row < place.size(); ++row)
        place[row] = is_held[row] != 0 ? -1 : rows++;
    const auto places_of = [&](const std::vector<Index>& rows_of_kind) {
        std::vector<Index> places;
        for (const Index row : rows_of_kind)
            if (const Index its = place[static_cast<std::size_t>(row)]; its >= 0) places.push_back(its);
        return places;
    };
    const std::vector<Index> inner = places_of(parting_.interior);
    const std::vector<Index> outer = places_of(parting_.boundary);
    return [this, boundary, inner, outer](const VectorXd& load) {
        VectorXd answer(load.size());
        const VectorXd inner_load = load(inner);
        VectorXd all = VectorXd::Zero(stiffness_.rows());  // the boundary, with the rows that are held
        if (!outer.empty()) {
            const VectorXd carried = constraint_.transpose() * inner_load;
            const VectorXd moved = boundary->solve(load(outer) + carried(boundary->free));
            all(boundary->free) = moved;
            answer(outer) = moved;
        }
        if (!inner.empty()) answer(inner) = VectorXd(factor_->solve(inner_load)) + constraint_ * all;
        return answer;
    };
}

MatrixXd CondensedPart::stiffness_error() const {
    if (constraint_.rows() == 0) return MatrixXd::Zero(stiffness_.rows(), stiffness_.rows());
    const SparseMatrix across = block(part_.stiffness, parting_, RowKind::interior, RowKind::boundary);
    const MatrixXd residual = inner_stiffness_ * constraint_ + across;
    return constraint_.transpose() * residual;
}

}  // namespace stridor::reduction
