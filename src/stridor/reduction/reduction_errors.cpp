#include "stridor/reduction/reduction_errors.hpp"

#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index most_rigid_modes = 6;
constexpr double free_pivot = 1e-10;   // [1] of the diagonal
constexpr double rigid_share = 1e-10;  // [1] of the highest omega^2 looked at: as good as zero

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

/// A part with some of its rows held, and its factors, which are most of the work.
struct HeldPart {
    SparseMatrix stiffness;
    SparseMatrix mass;
    SparseFactor factor;
    bool is_free;  // as it is held, it can still move without a force
};

HeldPart held_part(const ElasticPart& part, const std::vector<Index>& held) {
    SparseMatrix stiffness = without(part.stiffness, held);
    SparseMatrix mass = without(part.mass, held);
    SparseFactor factor(stiffness, mass, 0.0);
    const bool is_free = !factor.is_whole() || factor.negative_pivots() > 0 || factor.weakest_pivot() < free_pivot;
    return {stiffness, mass, std::move(factor), is_free};
}

// a mode that was missed would stand out: all behind it would seem to be wrong
std::vector<double> frequencies_of(const HeldPart& part, Index count) {
    if (part.is_free)
        return without_rigid_body(lowest_modes(part.stiffness, part.mass, count + most_rigid_modes), count);
    return without_rigid_body(lowest_modes(part.stiffness, part.mass, count, part.factor, ModeCount::trusted), count);
}

// (K^-1)_bb; nothing where the part is free
std::optional<MatrixXd> flexibility_of(const HeldPart& part, const std::vector<Index>& boundary) {
    if (part.is_free) return std::nullopt;
    const auto size = static_cast<Index>(boundary.size());
    MatrixXd loads = MatrixXd::Zero(part.stiffness.rows(), size);
    for (Index k = 0; k < size; ++k)
        loads(boundary[static_cast<std::size_t>(k)], k) = 1.0;
    const MatrixXd answers = part.factor.solve(loads);
    MatrixXd flexibility(size, size);
    for (Index k = 0; k < size; ++k)
        flexibility.row(k) = answers.row(boundary[static_cast<std::size_t>(k)]);
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

ReductionErrors reduction_errors(const ElasticPart& full, const ReductionRequest& request, const Reduction& reduction,
                                 const std::vector<HeldRows>& states, Index count) {
    ReductionErrors errors;
    std::vector<Index> boundary(static_cast<std::size_t>(reduction.boundary_rows));
    for (std::size_t k = 0; k < boundary.size(); ++k)
        boundary[k] = static_cast<Index>(k);
    for (const HeldRows& state : states) {
        std::vector<Index> held;
        for (const Index row : state.held)
            held.push_back(request.boundary[static_cast<std::size_t>(row)]);
        const HeldPart exact = held_part(full, held);
        const HeldPart reduced = held_part(reduction.part, state.held);
        const std::vector<double> wanted = frequencies_of(exact, count);
        const std::vector<double> got = frequencies_of(reduced, count);
        StateErrors& errors_of_state = errors.states.emplace_back(StateErrors{state.name, {}});
        for (std::size_t k = 0; k < std::min(wanted.size(), got.size()); ++k)
            errors_of_state.frequencies.push_back({wanted[k], got[k]});
        if (!held.empty()) continue;
        const auto flexibility = flexibility_of(exact, request.boundary);
        const auto its = flexibility_of(reduced, boundary);
        if (flexibility && its)
            errors.flexibility = (*flexibility - *its).cwiseAbs().maxCoeff() / flexibility->cwiseAbs().maxCoeff();
    }
    errors.coupling = coupling_of(reduction);
    return errors;
}

}  // namespace stridor::reduction
