#pragma once

#include "stridor/reduction/linear_solver.hpp"
#include "stridor/reduction/part.hpp"

#include <memory>

namespace stridor::reduction {

/// The factors of K - sigma M: L D L' after an ordering of least fill (Eigen's SimplicialLDLT), or those of MUMPS. All
/// large matrices are factorised here.
///
/// D holds as many negative pivots as the pencil (K, M) has eigenvalues below sigma (Sylvester's law of inertia), if M
/// is positive (semi)definite.
class SparseFactor {
public:
    SparseFactor(const SparseMatrix& stiffness, const SparseMatrix& mass, double sigma,
                 LinearSolver solver = LinearSolver::eigen, FactorUse use = FactorUse::solving);
    ~SparseFactor();
    SparseFactor(SparseFactor&&) noexcept;
    SparseFactor& operator=(SparseFactor&&) noexcept;

    /// Says whether the factorisation was completed. A pivot of zero ends it early.
    bool is_whole() const;

    /// Returns the number of eigenvalues below sigma [1].
    Eigen::Index negative_pivots() const;

    /// Returns the smallest ratio of a pivot's size to its row's diagonal [1]: about rounding (1e-16 to 1e-13) if the
    /// matrix is singular.
    double weakest_pivot() const;

    /// Returns (K - sigma M)^-1 of each column, by factors for solving. Eigen gives the same bits, whatever columns
    /// stand beside it.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace stridor::reduction
