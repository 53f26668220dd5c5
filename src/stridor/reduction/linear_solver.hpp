#pragma once

#include <string_view>

namespace stridor::reduction {

/// The program part that factorises the matrices.
enum class LinearSolver {
    eigen,  // the same bits on every machine
    mumps,  // large solids in a fraction of the time; the last bits depend on the machine's BLAS
};

/// The use of factors: MUMPS keeps no factors that only count eigenvalues.
enum class FactorUse { solving, counting };

/// Returns "eigen" or "mumps".
constexpr std::string_view name_of(LinearSolver solver) {
    return solver == LinearSolver::mumps ? "mumps" : "eigen";
}

/// Returns the solver of this name: MUMPS for "mumps", else Eigen.
constexpr LinearSolver solver_named(std::string_view name) {
    return name == name_of(LinearSolver::mumps) ? LinearSolver::mumps : LinearSolver::eigen;
}

}  // namespace stridor::reduction
