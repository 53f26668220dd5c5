#pragma once

#include <string_view>

namespace stridor::reduction {

/// Who factorises the matrices of a part.
enum class LinearSolver {
    eigen,  // the same bits on every machine
    mumps,  // large solids in a fraction of the time; the last bits hang on the BLAS that the machine has
};

/// What factors are for: MUMPS keeps none of those that are only counted.
enum class FactorUse { solving, counting };

/// "eigen", "mumps".
constexpr std::string_view name_of(LinearSolver solver) {
    return solver == LinearSolver::mumps ? "mumps" : "eigen";
}

/// The one of this name: MUMPS for "mumps", else Eigen.
constexpr LinearSolver solver_named(std::string_view name) {
    return name == name_of(LinearSolver::mumps) ? LinearSolver::mumps : LinearSolver::eigen;
}

}  // namespace stridor::reduction
