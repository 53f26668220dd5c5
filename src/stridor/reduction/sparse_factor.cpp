#include "stridor/reduction/sparse_factor.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::reduction {

struct SparseFactor::Held {
    Eigen::SimplicialLDLT<SparseMatrix> factor;
};

SparseFactor::SparseFactor(const SparseMatrix& stiffness, const SparseMatrix& mass, double sigma)
    : held_(std::make_unique<Held>()) {
    const SparseMatrix shifted = sigma == 0.0 ? stiffness : SparseMatrix(stiffness - sigma * mass);
    held_->factor.compute(shifted);
    if (!is_whole()) return;
    const Eigen::VectorXd pivots = held_->factor.permutationPinv() * held_->factor.vectorD();
    const Eigen::VectorXd diagonal = shifted.diagonal().cwiseAbs();
    weakest_ = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < pivots.size(); ++row)
        weakest_ = std::min(weakest_, diagonal[row] > 0.0 ? std::abs(pivots[row]) / diagonal[row] : 0.0);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor::is_whole() const {
    return held_->factor.info() == Eigen::Success;
}

Eigen::Index SparseFactor::negative_pivots() const {
    return (held_->factor.vectorD().array() < 0.0).count();
}

Eigen::MatrixXd SparseFactor::solve(const Eigen::MatrixXd& right) const {
    return held_->factor.solve(right);
}

}  // namespace stridor::reduction
