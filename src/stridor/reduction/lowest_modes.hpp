#pragma once

#include "stridor/reduction/linear_solver.hpp"
#include "stridor/reduction/part.hpp"

#include <functional>
#include <optional>

namespace stridor::reduction {

/// Modes of K x = omega^2 M x.
struct Modes {
    Eigen::VectorXd
        squared;             // [rad^2/s^2] omega^2, rising; rigid-body modes are zero to rounding, or a little negative
    Eigen::MatrixXd shapes;  // of unit mass: x'Mx = 1, largest entry positive; shape [row][mode]
};

/// Refuses a stiffness that is negative for some motion, by more than 1e-8 of the largest K_ii/M_ii, as which a
/// rigid-body motion may come out: throws `Error` (input). Rows without mass are held by stiffness.
void expect_no_buckling(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by = LinearSolver::eigen);

/// The lowest modes of a structure, as many as asked for, or as there are: rows without mass have none.
///
/// Shift-invert Lanczos (Ericsson and Ruhe, 1980; Spectra) about zero, or a little below it where the structure is
/// free. None is missed: below the highest of them the factors of K - sigma M count as many eigenvalues (Sylvester's
/// law of inertia) as were found; where they count more, the search goes on in what is orthogonal to those found, as it
/// must for modes of one frequency. Throws `Error` (numerical) where that does not help.
Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Eigen::Index count,
                   LinearSolver by = LinearSolver::eigen);

/// Who counts that no mode is missed: another factorisation, most of the time of a large part. Nothing: it is trusted.
using ModeCounter = std::optional<LinearSolver>;

/// The displacements under a load: K^-1 f.
using StaticSolver = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// The same with what solves with K, which is positive definite.
Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Eigen::Index count,
                   const StaticSolver& solver, ModeCounter counter);

/// How many modes lie below a frequency [Hz] (Sylvester's law of inertia).
Eigen::Index modes_below(const SparseMatrix& stiffness, const SparseMatrix& mass, double frequency,
                         LinearSolver by = LinearSolver::eigen);

/// The highest omega^2 [rad^2/s^2] by Lanczos, to 1e-4; infinite where a motion has no mass.
double highest_squared(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by = LinearSolver::eigen);

/// omega^2 [rad^2/s^2] as a frequency [Hz]; zero for what is negative.
double frequency_of(double squared);

/// A frequency [Hz] as omega^2 [rad^2/s^2].
double squared_of(double frequency);

}  // namespace stridor::reduction
