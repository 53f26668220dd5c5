#include "stridor/reduction/sparse_factor.hpp"

#include "stridor/reduction/least_fill.hpp"
#include "stridor/reduction/mumps_factor.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::reduction {

namespace {

// [1] right sides solved in one walk through the factors, which are too large for any cache; each has the bits of being
// solved alone
constexpr Eigen::Index at_once = 8;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, at_once, Eigen::RowMajor>;

using Factor = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, LeastFill>;

double weakest_pivot_of(const Factor& factor, const Eigen::VectorXd& diagonal) {
    const Eigen::VectorXd pivots = factor.permutationPinv() * factor.vectorD();
    double weakest = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < pivots.size(); ++row)
        weakest = std::min(weakest, diagonal[row] > 0.0 ? std::abs(pivots[row]) / diagonal[row] : 0.0);
    return weakest;
}

}  // namespace

struct SparseFactor::Held {
    Factor factor;
    double weakest = 0.0;                // [1] where `factor` is whole
    std::unique_ptr<MumpsFactor> mumps;  // stands in the place of `factor`; null: it does not
};

SparseFactor::SparseFactor(const SparseMatrix& stiffness, const SparseMatrix& mass, double sigma, LinearSolver solver,
                           FactorUse use)
    : held_(std::make_unique<Held>()) {
    const SparseMatrix shifted = sigma == 0.0 ? stiffness : SparseMatrix(stiffness - sigma * mass);
    if (solver == LinearSolver::mumps) {
        held_->mumps = std::make_unique<MumpsFactor>(shifted, use);
        return;
    }
    held_->factor.compute(shifted);
    if (is_whole()) held_->weakest = weakest_pivot_of(held_->factor, shifted.diagonal().cwiseAbs());
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor::is_whole() const {
    if (held_->mumps) return held_->mumps->is_whole();
    return held_->factor.info() == Eigen::Success;
}

Eigen::Index SparseFactor::negative_pivots() const {
    if (held_->mumps) return held_->mumps->negative_pivots();
    return (held_->factor.vectorD().array() < 0.0).count();
}

double SparseFactor::weakest_pivot() const {
    return held_->mumps ? held_->mumps->weakest_pivot() : held_->weakest;
}

Eigen::MatrixXd SparseFactor::solve(const Eigen::MatrixXd& right) const {
    if (held_->mumps) return held_->mumps->solve(right);
    if (right.cols() == 1 || right.rows() == 0) return held_->factor.solve(right);
    const SparseMatrix& lower = held_->factor.matrixL().nestedExpression();  // without its diagonal of ones
    const Eigen::VectorXd inverse = held_->factor.vectorD().cwiseInverse();
    Eigen::MatrixXd answer(right.rows(), right.cols());
    for (Eigen::Index from = 0; from < right.cols(); from += at_once) {
        const Eigen::Index count = std::min(at_once, right.cols() - from);
        Columns x = Columns::Zero(right.rows(), at_once);
        x.leftCols(count) = held_->factor.permutationP() * right.middleCols(from, count);
        for (Eigen::Index column = 0; column < lower.outerSize(); ++column)
            for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
                x.row(entry.row()) -= entry.value() * x.row(column);
        x = inverse.asDiagonal() * x;
        for (Eigen::Index column = lower.outerSize() - 1; column >= 0; --column)
            for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
                x.row(column) -= entry.value() * x.row(entry.row());
        answer.middleCols(from, count) = held_->factor.permutationPinv() * x.leftCols(count);
    }
    return answer;
}

}  // namespace stridor::reduction
