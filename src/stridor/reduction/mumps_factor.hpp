#pragma once

// Private to this module: the part of SparseFactor that uses LinearSolver::mumps.

#include "stridor/reduction/part.hpp"

#include <memory>

namespace stridor::reduction {

/// The factors of a symmetric matrix by MUMPS (Amestoy, Duff, L'Excellent and Koster, SIAM Journal on Matrix Analysis
/// and Applications 23, 2001, 15): multifrontal, with pivots of one or two rows that are chosen by size.
class MumpsFactor {
public:
    /// Factorises a matrix with both its triangles. Throws `Error` (io) if the library is not on this machine,
    /// (numerical) if it lacks memory.
    MumpsFactor(const SparseMatrix& matrix, FactorUse use);
    ~MumpsFactor();

    /// Says whether the factorisation was completed. A pivot of zero ends it early.
    bool is_whole() const;

    /// Returns the number of negative eigenvalues [1].
    Eigen::Index negative_pivots() const;

    /// Returns, for factors for solving, the smallest 1 / (A_ii (A^-1)_ii) [1] that a few steps uphill find: the pivot
    /// of row i over its diagonal, if the row were eliminated last.
    double weakest_pivot() const;

    /// Returns, by factors for solving, A^-1 of each column; its last bits depend on the columns beside it.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
    struct Held;
    std::unique_ptr<Held> held_;
    Eigen::VectorXd diagonal_;
};

}  // namespace stridor::reduction
