#pragma once

#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/part.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace stridor::reduction {

/// Rows in their new order, and the new place of each old row.
struct Parting {
    std::vector<Eigen::Index> boundary;
    std::vector<Eigen::Index> interior;
    std::vector<Eigen::Index> place;  // within its own list, shape [row]
    std::vector<char> is_boundary;
};

/// The two kinds of rows.
enum class RowKind { interior, boundary };

/// Returns the block of a matrix between rows and columns of these kinds.
SparseMatrix block(const SparseMatrix& matrix, const Parting& parting, RowKind rows, RowKind columns);

/// A part with its stiffness condensed to a boundary b; i is the interior:
///
///     Psi = -K_ii^-1 K_ib,    S = K_bb + K_bi Psi
///
/// K_ii is factorised once, which is most of the work of a large part. With S the part is solved with any rows of its
/// boundary held: u_b = S_ff^-1 (f_b + Psi' f_i), u_i = K_ii^-1 f_i + Psi u_b.
class CondensedPart {
public:
    /// Keeps a reference to the part, which must be sound and in SI. Throws `Error` (input) if the boundary is empty,
    /// names a row twice, or does not hold the part still (a mechanism would remain inside).
    CondensedPart(const ElasticPart& part, const std::vector<Eigen::Index>& boundary,
                  LinearSolver by = LinearSolver::eigen);

    const ElasticPart& part() const { return part_; }
    /// Returns the solver that factorises the full part.
    LinearSolver linear_solver() const { return linear_solver_; }
    const Parting& parting() const { return parting_; }
    const SparseMatrix& inner_stiffness() const { return inner_stiffness_; }
    const SparseMatrix& inner_mass() const { return inner_mass_; }
    /// Returns Psi [1], shape [interior][boundary].
    const Eigen::MatrixXd& constraint() const { return constraint_; }
    /// Returns S [N/m ...], symmetric, shape [boundary][boundary].
    const Eigen::MatrixXd& stiffness() const { return stiffness_; }

    /// Returns the solver K_ii^-1 of a load on the interior.
    StaticSolver inner_solver() const;
    /// Returns the part's answer to a load while some rows of the boundary (by their place in it) do not move, or
    /// `std::nullopt` if the part can then move freely. Load and answer lack those rows and have the order of the part.
    std::optional<StaticSolver> solver(const std::vector<Eigen::Index>& held) const;

    /// Returns the error of S for these factors [N/m ...]: Psi' (K_ii Psi + K_ib), zero but for rounding.
    Eigen::MatrixXd stiffness_error() const;

private:
    const ElasticPart& part_;
    LinearSolver linear_solver_;
    Parting parting_;
    SparseMatrix inner_stiffness_;
    SparseMatrix inner_mass_;
    std::unique_ptr<SparseFactor> factor_;  // null without an interior
    Eigen::MatrixXd constraint_;
    Eigen::MatrixXd stiffness_;
};

}  // namespace stridor::reduction
