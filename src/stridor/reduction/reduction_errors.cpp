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
constexpr double is_free = 1e-10;      // [1] of the diagonal
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

std::vector<double> frequencies_of(const ElasticPart& part, const std::vector<Index>& held, Index count) {
    const Modes modes = lowest_modes(without(part.stiffness, held), without(part.mass, held), count + most_rigid_modes);
    std::vector<double> frequencies;
    const double small = modes.squared.size() == 0 ? 0.0 : rigid_share * modes.squared.maxCoeff();
    for (Index k = 0; k < modes.squared.size(); ++k)
        if (modes.squared[k] > small && static_cast<Index>(frequencies.size()) < count)
            frequencies.push_back(frequency_of(modes.squared[k]));
    return frequencies;
}

// (K^-1)_bb; nothing where the part is free
std::optional<MatrixXd> flexibility_of(const ElasticPart& part, const std::vector<Index>& boundary) {
    const SparseFactor factor(part.stiffness, part.mass, 0.0);
    if (!factor.is_whole() || factor.negative_pivots() > 0 || factor.weakest_pivot() < is_free) return std::nullopt;
    const auto size = static_cast<Index>(boundary.size());
    MatrixXd loads = MatrixXd::Zero(rows_of(part), size);
    for (Index k = 0; k < size; ++k)
        loads(boundary[static_cast<std::size_t>(k)], k) = 1.0;
    const MatrixXd answers = factor.solve(loads);
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
    std::vector<HeldRows> states{{"open", {}}, {"sliding", {}}, {"stuck", {}}};
    for (Index row = 0; row < reduction.boundary_rows; ++row) {
        if (reduction.part.labels[static_cast<std::size_t>(row)].component == normal) states[1].held.push_back(row);
        states[2].held.push_back(row);
    }
    if (states[1].held.empty() || states[1].held.size() == states[2].held.size()) states.erase(states.begin() + 1);
    return states;
}

ReductionErrors reduction_errors(const ElasticPart& full, const ReductionRequest& request, const Reduction& reduction,
                                 const std::vector<HeldRows>& states, Index count) {
    ReductionErrors errors;
    for (const HeldRows& state : states) {
        std::vector<Index> held;
        for (const Index row : state.held)
            held.push_back(request.boundary[static_cast<std::size_t>(row)]);
        const std::vector<double> wanted = frequencies_of(full, held, count);
        const std::vector<double> got = frequencies_of(reduction.part, state.held, count);
        StateErrors& errors_of_state = errors.states.emplace_back(StateErrors{state.name, {}});
        for (std::size_t k = 0; k < std::min(wanted.size(), got.size()); ++k)
            errors_of_state.frequencies.push_back({wanted[k], got[k]});
    }
    std::vector<Index> boundary(static_cast<std::size_t>(reduction.boundary_rows));
    for (std::size_t k = 0; k < boundary.size(); ++k)
        boundary[k] = static_cast<Index>(k);
    const auto exact = flexibility_of(full, request.boundary);
    const auto reduced = flexibility_of(reduction.part, boundary);
    if (exact && reduced) errors.flexibility = (*exact - *reduced).cwiseAbs().maxCoeff() / exact->cwiseAbs().maxCoeff();
    errors.coupling = coupling_of(reduction);
    return errors;
}

}  // namespace stridor::reduction
