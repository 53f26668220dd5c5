#pragma once

// Private to this module: what stands behind SparseFactor with LinearSolver::mumps.

#include "stridor/reduction/part.hpp"

#include <memory>

namespace stridor::reduction {

/// The factors of a symmetric matrix by MUMPS (Amestoy, Duff, L'Excellent and Koster, SIAM Journal on Matrix Analysis
/// and Applications 23, 2001, 15): multifrontal, with pivots of one or two rows that are chosen by size.
class MumpsFactor {
public:
    /// Of a matrix with both its triangles. Throws `Error` (io) where the library is not on this machine, (numerical)
    /// where it lacks memory.
    MumpsFactor(const SparseMatrix& matrix, FactorUse use);
    ~MumpsFactor();

    /// Did it come to its end? A pivot of zero ends it.
    bool is_whole() const;

    /// Number of negative eigenvalues [1].
    Eigen::Index negative_pivots() const;

    /// Of factors for solving: the smallest 1 / (A_ii (A^-1)_ii) [1] that a few steps uphill find. That is the pivot of
    /// row i over its diagonal, were it the last one.
    double weakest_pivot() const;

    /// Of factors for solving: A^-1 of each column; its last bits hang on the columns beside it.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
    struct Held;
    std::unique_ptr<Held> held_;
    Eigen::VectorXd diagonal_;
};

}  // namespace stridor::reduction
