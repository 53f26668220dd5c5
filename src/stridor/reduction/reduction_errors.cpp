#include "stridor/reduction/reduction_errors.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index most_rigid_modes = 6;
constexpr double most_believed_error = 0.01;  // [1] of a frequency: beyond it is another part
constexpr double free_pivot = 1e-10;          // [1] of the diagonal
constexpr double rigid_share = 1e-10;         // [1] of the highest omega^2 looked at: as good as zero

// without the rows that are held
SparseMatrix without(const SparseMatrix& matrix, const std::vector<Index>& held) {
    std::vector<Index> place(static_cast<std::size_t>(matrix.rows()), 0);
    for (const Index row : held)
        place[static_cast<std::size_t>(row)] = -1;
    Index free = 0;
    for (Index& each : place)
        if (each == 0) each = free++;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            const Index row = place[static_cast<std::size_t>(entry.row())];
            const Index into = place[static_cast<std::size_t>(column)];
            if (row >= 0 && into >= 0) entries.emplace_back(row, into, entry.value());
        }
    SparseMatrix left(free, free);
    left.setFromTriplets(entries.begin(), entries.end());
    return left;
}

std::vector<double> without_rigid_body(const Modes& modes, Index count) {
    std::vector<double> frequencies;
    const double small = modes.squared.size() == 0 ? 0.0 : rigid_share * modes.squared.maxCoeff();
    for (Index k = 0; k < modes.squared.size(); ++k)
        if (modes.squared[k] > small && static_cast<Index>(frequencies.size()) < count)
            frequencies.push_back(frequency_of(modes.squared[k]));
    return frequencies;
}

// a mode that was missed would stand out: all behind it would seem to be wrong
std::vector<double> frequencies_of(const ElasticPart& part, const std::vector<Index>& held,
                                   const std::optional<StaticSolver>& solver, Index count, LinearSolver by) {
    const SparseMatrix stiffness = without(part.stiffness, held);
    const SparseMatrix mass = without(part.mass, held);
    if (!solver) return without_rigid_body(lowest_modes(stiffness, mass, count + most_rigid_modes, by), count);
    return without_rigid_body(lowest_modes(stiffness, mass, count, *solver, std::nullopt), count);
}

// nothing where the part can move freely
std::optional<StaticSolver> solver_of(const ElasticPart& part, const std::vector<Index>& held) {
    const SparseMatrix stiffness = without(part.stiffness, held);
    const auto factor = std::make_shared<const SparseFactor>(stiffness, without(part.mass, held), 0.0);
    if (!factor->is_whole() || factor->negative_pivots() > 0 || factor->weakest_pivot() < free_pivot)
        return std::nullopt;
    return [factor](const Eigen::VectorXd& load) { return Eigen::VectorXd(factor->solve(load)); };
}

// (K^-1)_bb
MatrixXd flexibility_of(const CondensedPart& part) {
    const MatrixXd error = part.stiffness_error();
    const MatrixXd stiffness = part.stiffness() + 0.5 * (error + error.transpose());
    return stiffness.ldlt().solve(MatrixXd::Identity(stiffness.rows(), stiffness.cols()));
}

MatrixXd flexibility_of(const Reduction& reduction, const StaticSolver& solver) {
    MatrixXd flexibility(reduction.boundary_rows, reduction.boundary_rows);
    for (Index k = 0; k < flexibility.cols(); ++k)
        flexibility.col(k) = solver(Eigen::VectorXd::Unit(rows_of(reduction.part), k)).head(reduction.boundary_rows);
    return flexibility;
}

double coupling_of(const Reduction& reduction) {
    const Index boundary = reduction.boundary_rows;
    const MatrixXd mass(reduction.part.mass);
    const MatrixXd across = mass.topRightCorner(boundary, mass.cols() - boundary);
    const MatrixXd inertia = mass.topLeftCorner(boundary, boundary) - across * across.transpose();
    double coupling = 0.0;
    for (Index row = 0; row < boundary; ++row)
        for (Index column = 0; column < row; ++column) {
            const double scale = std::sqrt(std::abs(inertia(row, row) * inertia(column, column)));
            // what lumping cancelled is left to rounding
            if (scale > 0.0) coupling = std::max(coupling, std::abs(inertia(row, column)) / scale);
        }
    return coupling;
}

}  // namespace

double relative_error(const FrequencyPair& pair) {
    return pair.full > 0.0 ? pair.reduced / pair.full - 1.0 : 0.0;
}

std::vector<HeldRows> contact_states(const Reduction& reduction, int normal) {
    std::vector<HeldRows> states{{"open", {}}};
    HeldRows sliding{"sliding", {}};
    for (Index row = 0; row < reduction.boundary_rows; ++row)
        if (reduction.part.labels[static_cast<std::size_t>(row)].component == normal) sliding.held.push_back(row);
    if (normal != 0 && !sliding.held.empty()) states.push_back(std::move(sliding));
    return states;
}

ReductionErrors reduction_errors(const CondensedPart& full, const Reduction& reduction,
                                 const std::vector<HeldRows>& states, Index count) {
    ReductionErrors errors;
    for (const HeldRows& state : states) {
        std::vector<Index> held;
        for (const Index row : state.held)
            held.push_back(full.parting().boundary[static_cast<std::size_t>(row)]);
        const auto exact = full.solver(state.held);
        const auto reduced = solver_of(reduction.part, state.held);
        const std::vector<double> wanted = frequencies_of(full.part(), held, exact, count, full.linear_solver());
        const std::vector<double> got = frequencies_of(reduction.part, state.held, reduced, count, LinearSolver::eigen);
        StateErrors& errors_of_state = errors.states.emplace_back(StateErrors{state.name, {}});
        for (std::size_t k = 0; k < std::min(wanted.size(), got.size()); ++k)
            errors_of_state.frequencies.push_back({wanted[k], got[k]});
        if (!held.empty() || !exact || !reduced) continue;
        const MatrixXd flexibility = flexibility_of(full);
        errors.flexibility = (flexibility - flexibility_of(reduction, *reduced)).cwiseAbs().maxCoeff() /
                             flexibility.cwiseAbs().maxCoeff();
    }
    errors.coupling = coupling_of(reduction);
    return errors;
}

std::string errors_doubt(const Reduction& reduction, const ReductionErrors& errors) {
    std::ptrdiff_t beyond = 0;
    for (const StateErrors& state : errors.states)
        beyond += std::count_if(state.frequencies.begin(), state.frequencies.end(),
                                [](const auto& pair) { return std::abs(relative_error(pair)) > most_believed_error; });
    if (beyond == 0) return "";
    const bool has_inertia = reduction.inertia != BoundaryInertia::massless;
    return fmt::format("{} frequenc{} more than 1 % off. Keep more modes{}", beyond, beyond == 1 ? "y is" : "ies are",
                       has_inertia ? "; if --inertia consistent is closer, refine the mesh at the contact."
                                   : ", or reduce by Craig-Bampton, which is closer with held contacts.");
}

}  // namespace stridor::reduction
