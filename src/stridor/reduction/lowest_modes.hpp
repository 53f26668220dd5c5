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

/// Refuses a stiffness that is negative for some motion: throws `Error` (input) if one is below zero by more than 1e-8
/// of the largest K_ii/M_ii, the rounding of a rigid-body motion. Rows without mass are held by stiffness.
void expect_no_buckling(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by = LinearSolver::eigen);

/// Returns the lowest modes of a structure, `count` of them or as many as there are: rows without mass have none.
///
/// Shift-invert Lanczos (Ericsson and Ruhe, 1980; Spectra) about zero, or slightly below zero for a free structure. No
/// mode is missed: below the highest found mode the factors of K - sigma M count the eigenvalues (Sylvester's law of
/// inertia). If they count more than were found, the search goes on in the space orthogonal to those found; modes of
/// one frequency need that. Throws `Error` (numerical) if modes are still missing.
Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Eigen::Index count,
                   LinearSolver by = LinearSolver::eigen);

/// The solver that counts whether a mode is missing: another factorisation, most of the time of a large part.
/// `std::nullopt`: no count.
using ModeCounter = std::optional<LinearSolver>;

/// Returns the displacements under a load, K^-1 f.
using StaticSolver = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Returns the lowest modes, found with a solver of K, which must be positive definite. Throws `Error` (numerical) if
/// modes are still missing.
Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Eigen::Index count,
                   const StaticSolver& solver, ModeCounter counter);

/// Returns the number of modes below a frequency [Hz] (Sylvester's law of inertia).
Eigen::Index modes_below(const SparseMatrix& stiffness, const SparseMatrix& mass, double frequency,
                         LinearSolver by = LinearSolver::eigen);

/// Returns the highest omega^2 [rad^2/s^2] by Lanczos, to 1e-4; infinite if a motion has no mass.
double highest_squared(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by = LinearSolver::eigen);

/// Returns omega^2 [rad^2/s^2] as a frequency [Hz]; zero if it is negative.
double frequency_of(double squared);

/// Returns a frequency [Hz] as omega^2 [rad^2/s^2].
double squared_of(double frequency);

}  // namespace stridor::reduction
