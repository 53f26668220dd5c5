#include "stridor/reduction/lowest_modes.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <Spectra/SymGEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index few_rows = 60;          // [1] up to which all modes are computed at once
constexpr double is_singular = 1e-10;   // [1] of the diagonal: such a pivot is rounding of files with few digits
constexpr double shift_of_free = 1e-8;  // [1] of the largest K_ii/M_ii: below zero, and above rounding
constexpr double lanczos_tolerance = 1e-12;
constexpr double residual_of_highest = 1e-4;  // [1] the eigenvalue is as good as its square where others are apart
constexpr double no_mode = 1e-13;             // [1] of the largest 1/(omega^2 - sigma): motions without mass
constexpr double margin = 1e-6;               // [1] of omega^2: where it counts below the highest mode

[[noreturn]] void give_up(const std::string& why) {
    throw Error(ErrorKind::numerical, {"the modes of the structure were not found", why, "Ask for fewer modes?"});
}

double largest_ratio(const SparseMatrix& stiffness, const SparseMatrix& mass) {
    const VectorXd k = stiffness.diagonal();
    const VectorXd m = mass.diagonal();
    double largest = 0.0;
    for (Index row = 0; row < k.size(); ++row)
        if (m[row] > 0.0) largest = std::max(largest, std::abs(k[row]) / m[row]);
    return largest;
}

/// What the Lanczos process multiplies with: (K - sigma M)^-1, and nothing of the modes that are known. Times a power
/// of two that makes it about one, for the library's thresholds are numbers: units change no mode.
class InverseOperator {
public:
    using Scalar = double;

    InverseOperator(const StaticSolver& solver, const SparseMatrix& mass, const MatrixXd& known)
        : solver_(solver),
          known_(known),
          mass_known_(mass * known) {
        const VectorXd moved = solver(mass * VectorXd::Ones(mass.rows()));
        const double size = moved.cwiseAbs().maxCoeff();
        if (size > 0.0 && std::isfinite(size)) factor_ = std::ldexp(1.0, -std::ilogb(size));
    }

    double factor() const { return factor_; }  // [rad^2/s^2]
    Index rows() const { return known_.rows(); }
    Index cols() const { return known_.rows(); }
    void set_shift(double) {}  // the factors have it
    void perform_op(const double* in, double* out) const {
        VectorXd x = solver_(Eigen::Map<const VectorXd>(in, rows()));
        x -= known_ * (mass_known_.transpose() * x);
        Eigen::Map<VectorXd>(out, rows()) = factor_ * x;
    }

private:
    const StaticSolver& solver_;
    const MatrixXd& known_;
    MatrixXd mass_known_;
    double factor_ = 1.0;
};

/// Solves with M, for the highest frequency.
class MassOperator {
public:
    using Scalar = double;

    MassOperator(const SparseMatrix& mass, LinearSolver by)
        : mass_(mass),
          factor_(without_zeros(mass), mass, 0.0, by) {}

    Index rows() const { return mass_.rows(); }
    Index cols() const { return mass_.rows(); }
    bool is_regular() const {
        return factor_.is_whole() && factor_.negative_pivots() == 0 && factor_.weakest_pivot() > is_singular;
    }
    void solve(const double* in, double* out) const {
        Eigen::Map<VectorXd>(out, rows()) = factor_.solve(Eigen::Map<const VectorXd>(in, rows()));
    }
    void perform_op(const double* in, double* out) const {
        Eigen::Map<VectorXd>(out, rows()).noalias() = mass_ * Eigen::Map<const VectorXd>(in, rows());
    }

private:
    const SparseMatrix& mass_;
    SparseFactor factor_;
};

struct Shifted {
    double sigma = 0.0;  // [rad^2/s^2]
    SparseFactor factor;
};

/// What solves with K - sigma M.
struct SolverAt {
    double sigma = 0.0;  // [rad^2/s^2]
    const StaticSolver& solver;
};

[[noreturn]] void refuse_buckling() {
    throw Error(ErrorKind::input,
                {"the stiffness is negative for some motion", "the structure would buckle by itself",
                 "Is it a stiffness matrix, whole, and without Lagrange multipliers? Code_Aster: AFFE_CHAR_CINE."});
}

// where rigid-body modes may come out, and no lower: beside the largest K_ii/M_ii
double below_rigid_body(const SparseMatrix& stiffness, const SparseMatrix& mass) {
    const double ratio = largest_ratio(stiffness, mass);
    return -shift_of_free * (ratio > 0.0 ? ratio : 1.0);
}

// zero itself where the structure is held, else a little below the rigid-body modes
Shifted shifted(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by) {
    SparseFactor at_zero(stiffness, mass, 0.0, by);
    if (at_zero.is_whole() && at_zero.negative_pivots() == 0 && at_zero.weakest_pivot() > is_singular)
        return {0.0, std::move(at_zero)};
    double sigma = below_rigid_body(stiffness, mass);
    for (int attempt = 0; attempt < 8; ++attempt, sigma *= 10.0) {
        SparseFactor factor(stiffness, mass, sigma, by);
        if (factor.is_whole() && factor.negative_pivots() == 0) return {sigma, std::move(factor)};
    }
    refuse_buckling();
}

// the library's words as ours: without stiffness or mass it has no vector to begin with, or numbers without end
template <typename Solver>
void run_lanczos(Solver& solver, Spectra::SortRule rule, double tolerance) {
    constexpr Index most_restarts = 300;
    try {
        solver.init();
        solver.compute(rule, most_restarts, tolerance);
    } catch (const Error&) {
        throw;
    } catch (const std::invalid_argument& error) {
        give_up(std::string("Lanczos did not begin: ") + error.what());
    } catch (const std::runtime_error& error) {
        give_up(std::string("Lanczos broke off: ") + error.what());
    }
}

// the modes behind 1/(omega^2 - sigma), lowest first; those without mass are left out
void append(Modes& modes, const VectorXd& inverse, const MatrixXd& vectors, const SparseMatrix& mass, double sigma) {
    std::vector<std::pair<double, VectorXd>> all;
    for (Index k = 0; k < modes.squared.size(); ++k)
        all.emplace_back(modes.squared[k], modes.shapes.col(k));
    for (Index k = 0; k < inverse.size(); ++k) {
        if (!(inverse[k] > no_mode * inverse.maxCoeff())) continue;
        VectorXd shape = vectors.col(k);
        shape /= std::sqrt(shape.dot(mass * shape));
        Index largest = 0;
        shape.cwiseAbs().maxCoeff(&largest);
        if (shape[largest] < 0.0) shape = -shape;
        all.emplace_back(sigma + 1.0 / inverse[k], std::move(shape));
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    modes.squared.resize(static_cast<Index>(all.size()));
    modes.shapes.resize(mass.rows(), modes.squared.size());
    for (Index k = 0; k < modes.squared.size(); ++k) {
        modes.squared[k] = all[static_cast<std::size_t>(k)].first;
        modes.shapes.col(k) = all[static_cast<std::size_t>(k)].second;
    }
}

void keep_lowest(Modes& modes, Index count) {
    if (modes.squared.size() <= count) return;
    modes.squared.conservativeResize(count);
    modes.shapes.conservativeResize(Eigen::NoChange, count);
}

Modes dense_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, double sigma) {
    const MatrixXd right = MatrixXd(stiffness) - sigma * MatrixXd(mass);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(MatrixXd(mass), right);
    if (solver.info() != Eigen::Success) give_up("the dense solver did not converge");
    Modes modes;
    append(modes, solver.eigenvalues(), solver.eigenvectors(), mass, sigma);
    return modes;
}

void find_more(Modes& modes, const SolverAt& at, const SparseMatrix& mass, Index more) {
    using Product = Spectra::SparseSymMatProd<double>;
    if (modes.shapes.rows() == 0) modes.shapes.resize(mass.rows(), 0);
    const MatrixXd known = modes.shapes;
    InverseOperator inverse(at.solver, mass, known);
    Product product(mass);
    const Index rows = mass.rows();
    const Index wanted = std::min(more, rows - 1);
    const Index basis = std::min(rows, std::max<Index>(2 * wanted + 10, 20));
    Spectra::SymGEigsShiftSolver<InverseOperator, Product, Spectra::GEigsMode::ShiftInvert> solver(
        inverse, product, wanted, basis, at.sigma / inverse.factor());
    run_lanczos(solver, Spectra::SortRule::LargestMagn, lanczos_tolerance);
    if (solver.info() != Spectra::CompInfo::Successful)
        give_up(fmt::format("Lanczos did not converge for {} modes of {} rows", wanted, rows));
    const VectorXd squared = inverse.factor() * solver.eigenvalues();
    append(modes, (squared.array() - at.sigma).inverse().matrix(), solver.eigenvectors(), mass, at.sigma);
}

// how many eigenvalues lie below the highest of these modes, and were not found
Index missed(const Modes& modes, const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by) {
    const double highest = modes.squared[modes.squared.size() - 1];
    const double below = highest - margin * std::abs(highest);
    const SparseFactor factor(stiffness, mass, below, by, FactorUse::counting);
    if (!factor.is_whole()) give_up("the eigenvalues below the highest mode could not be counted");
    return factor.negative_pivots() - (modes.squared.array() < below).count();
}

Modes modes_at(const SparseMatrix& stiffness, const SparseMatrix& mass, Index count, const SolverAt& at,
               ModeCounter counter) {
    Modes modes;
    if (stiffness.rows() <= few_rows || 3 * count > stiffness.rows()) {
        modes = dense_modes(stiffness, mass, at.sigma);
        keep_lowest(modes, count);
        return modes;
    }
    find_more(modes, at, mass, count);
    keep_lowest(modes, count);
    constexpr int most_searches = 20;
    for (int search = 0; modes.squared.size() > 0 && counter; ++search) {
        const Index lacking = missed(modes, stiffness, mass, *counter);
        if (lacking == 0) return modes;
        if (lacking < 0 || search == most_searches) give_up("some of them hide behind others of the same frequency");
        find_more(modes, at, mass, lacking);
        keep_lowest(modes, count);
    }
    return modes;
}

}  // namespace

void expect_no_buckling(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by) {
    const SparseFactor factor(stiffness, mass, below_rigid_body(stiffness, mass), by, FactorUse::counting);
    if (!factor.is_whole() || factor.negative_pivots() > 0) refuse_buckling();
}

Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Index count, LinearSolver by) {
    const Index rows = stiffness.rows();
    if (count <= 0 || rows == 0) return {VectorXd(0), MatrixXd(rows, 0)};
    const Shifted at = shifted(stiffness, mass, by);
    const StaticSolver solver = [&at](const VectorXd& load) { return VectorXd(at.factor.solve(load)); };
    return modes_at(stiffness, mass, count, {at.sigma, solver}, by);
}

Modes lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, Index count, const StaticSolver& solver,
                   ModeCounter counter) {
    if (count <= 0) return {VectorXd(0), MatrixXd(stiffness.rows(), 0)};
    return modes_at(stiffness, mass, count, {0.0, solver}, counter);
}

Index modes_below(const SparseMatrix& stiffness, const SparseMatrix& mass, double frequency, LinearSolver by) {
    const SparseFactor factor(stiffness, mass, squared_of(frequency), by, FactorUse::counting);
    if (!factor.is_whole())
        give_up(fmt::format("the modes below {} Hz could not be counted: one lies there", frequency));
    return factor.negative_pivots();
}

double highest_squared(const SparseMatrix& stiffness, const SparseMatrix& mass, LinearSolver by) {
    using Product = Spectra::SparseSymMatProd<double>;
    MassOperator inertia(mass, by);
    if (!inertia.is_regular()) return std::numeric_limits<double>::infinity();
    if (mass.rows() <= few_rows) {
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(MatrixXd(stiffness), MatrixXd(mass),
                                                                        Eigen::EigenvaluesOnly);
        return solver.eigenvalues().maxCoeff();
    }
    Product product(stiffness);
    constexpr Index basis = 40;
    Spectra::SymGEigsSolver<Product, MassOperator, Spectra::GEigsMode::RegularInverse> solver(product, inertia, 1,
                                                                                              basis);
    run_lanczos(solver, Spectra::SortRule::LargestAlge, residual_of_highest);
    if (solver.info() != Spectra::CompInfo::Successful) give_up("the highest did not converge");
    return solver.eigenvalues()[0];
}

double frequency_of(double squared) {
    return squared > 0.0 ? std::sqrt(squared) / base::two_pi : 0.0;
}

double squared_of(double frequency) {
    const double omega = base::two_pi * frequency;
    return omega * omega;
}

}  // namespace stridor::reduction
