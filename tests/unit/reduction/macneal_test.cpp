#include "stridor/reduction/macneal.hpp"

#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/reduction_errors.hpp"
#include "support/error_text.hpp"
#include "support/structures/lattice_part.hpp"
#include "unit/reduction/worst_error.hpp"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace stridor::reduction {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using support::lattice_part;
using support::LatticeSupport;
using support::thrown_by;

ElasticPart held_block() {
    return lattice_part({4, 3, 4}, LatticeSupport::top_held);
}

ReductionRequest foot_of(const ElasticPart& part, Index modes) {
    return {.boundary = named_rows(part, "FOOT"), .modes = modes};
}

TEST(MacNeal, HasTheFreeModesOfTheFullPart) {
    const ElasticPart part = held_block();
    const ReductionRequest request = foot_of(part, 8);
    const CondensedPart condensed(part, request.boundary);
    const Reduction reduction = macneal(condensed, request);
    EXPECT_NO_THROW(expect_sound(reduction.part));
    EXPECT_EQ(reduction.boundary_rows, 36);
    EXPECT_EQ(describe(reduction.part.labels[36]), "mode 1");
    const auto errors = reduction_errors(condensed, reduction, {{"open", {}}}, 6);
    EXPECT_EQ(errors.states.front().frequencies.size(), 6U);
    EXPECT_LT(worst_error(errors.states.front()), 1e-11);
}

TEST(MacNeal, IsExactInStaticsWhateverIsKept) {
    const ElasticPart part = held_block();
    for (const Index modes : {0, 3, 12}) {
        const ReductionRequest request = foot_of(part, modes);
        const CondensedPart condensed(part, request.boundary);
        const auto errors = reduction_errors(condensed, macneal(condensed, request), {{"open", {}}}, 1);
        ASSERT_TRUE(errors.flexibility);
        EXPECT_LT(*errors.flexibility, 1e-10) << modes;
    }
}

// whatever lies below has no inertia: a frequency with held contacts comes from above
TEST(MacNeal, ComesCloserToHeldContactsFromAboveWithEachMode) {
    const ElasticPart part = held_block();
    double before = 1.0;
    for (const Index modes : {6, 15, 40}) {
        const ReductionRequest request = foot_of(part, modes);
        const CondensedPart condensed(part, request.boundary);
        const Reduction reduction = macneal(condensed, request);
        const auto states = contact_states(reduction, 3);
        const auto errors = reduction_errors(condensed, reduction, {states.back()}, 3);
        for (const FrequencyPair& pair : errors.states.front().frequencies)
            EXPECT_GT(relative_error(pair), -1e-12);
        EXPECT_LT(worst_error(errors.states.front()), before) << modes;
        before = worst_error(errors.states.front());
    }
    EXPECT_LT(before, 1e-3);
}

// the mass of the boundary is none, not a small one: zeroing that of Craig-Bampton is wrong by a factor of two and more
TEST(MacNeal, IsNotCraigBamptonWithoutMass) {
    const ElasticPart part = held_block();
    const ReductionRequest request = foot_of(part, 12);
    const CondensedPart condensed(part, request.boundary);
    Reduction naive = craig_bampton(condensed, request);
    MatrixXd mass(naive.part.mass);
    mass.topRows(36).setZero();
    mass.leftCols(36).setZero();
    naive.part.mass = mass.sparseView(0.0, 0.0);
    const auto naive_errors = reduction_errors(condensed, naive, {{"open", {}}}, 3);
    EXPECT_GT(worst_error(naive_errors.states.front()), 0.5);
    const Reduction reduction = macneal(condensed, request);
    EXPECT_EQ(reduction.inertia, BoundaryInertia::massless);
    EXPECT_EQ(MatrixXd(reduction.part.mass).topRows(36).norm(), 0.0);
    EXPECT_EQ(reduction_errors(condensed, reduction, {}, 1).coupling, 0.0);
}

TEST(MacNeal, RecoversTheMotionOfOtherRows) {
    const ElasticPart part = held_block();
    ReductionRequest request = foot_of(part, 4);
    request.recovered = {60, 75, 0};
    const Reduction reduction = macneal(CondensedPart(part, request.boundary), request);
    VectorXd load = VectorXd::Zero(rows_of(part));
    load[5] = 10.0;
    const VectorXd exact = Eigen::SimplicialLDLT<SparseMatrix>(part.stiffness).solve(load);
    const VectorXd reduced =
        Eigen::SimplicialLDLT<SparseMatrix>(reduction.part.stiffness).solve(load.head(rows_of(reduction.part)));
    const VectorXd recovered = reduction.recovery * reduced;
    for (const Index k : {0, 1, 2})
        EXPECT_NEAR(recovered[k] / exact[request.recovered[static_cast<std::size_t>(k)]], 1.0, 1e-10);
}

// a damping stays with the modes: a boundary without mass would hold it against nothing
TEST(MacNeal, LeavesItsBoundaryUndamped) {
    ElasticPart part = held_block();
    part.damping = 3.0 * part.mass;
    const ReductionRequest request = foot_of(part, 5);
    const MatrixXd damping(macneal(CondensedPart(part, request.boundary), request).part.damping);
    EXPECT_EQ(damping.topRows(36).norm(), 0.0);
    EXPECT_LT((damping.bottomRightCorner(5, 5) - 3.0 * MatrixXd::Identity(5, 5)).norm(), 1e-11);
}

TEST(MacNeal, RefusesWhatHasNoFlexibility) {
    const ElasticPart loose = lattice_part({4, 3, 4}, LatticeSupport::free);
    const ReductionRequest request = foot_of(loose, 6);
    EXPECT_TRUE(
        thrown_by([&] { macneal(CondensedPart(loose, request.boundary), request); }).says("the part can move freely"));
    const ElasticPart part = held_block();
    const ReductionRequest all = foot_of(part, rows_of(part));
    EXPECT_TRUE(thrown_by([&] {
                    macneal(CondensedPart(part, all.boundary), all);
                }).says("108 modes leave nothing to give way at the boundary"));
}

// K_ii^-1 and the condensed stiffness are the part itself, whatever is held
TEST(CondensedPart, SolvesThePartWithRowsHeld) {
    const ElasticPart part = held_block();
    const ReductionRequest request = foot_of(part, 0);
    const CondensedPart condensed(part, request.boundary);
    const std::vector<Index> held{2, 5, 8, 30};
    std::vector<Index> kept;
    for (Index row = 0; row < rows_of(part); ++row)
        if (row != request.boundary[2] && row != request.boundary[5] && row != request.boundary[8] &&
            row != request.boundary[30])
            kept.push_back(row);
    const MatrixXd stiffness = MatrixXd(part.stiffness)(kept, kept);
    const VectorXd load = VectorXd::LinSpaced(stiffness.rows(), -1.0, 2.0);
    const auto solver = condensed.solver(held);
    ASSERT_TRUE(solver);
    EXPECT_LT((stiffness * (*solver)(load)-load).norm(), 1e-10 * load.norm());
    EXPECT_LT(condensed.stiffness_error().norm(), 1e-12 * condensed.stiffness().norm());
    EXPECT_FALSE(CondensedPart(lattice_part({4, 3, 4}, LatticeSupport::free), request.boundary).solver({}));
}

TEST(SparseFactor, SolvesManyRightSidesWithTheBitsOfOne) {
    const ElasticPart part = held_block();
    const SparseFactor factor(part.stiffness, part.mass, 0.0);
    for (const Index columns : {2, 8, 19}) {
        MatrixXd loads(rows_of(part), columns);
        for (Index k = 0; k < columns; ++k)
            loads.col(k) = VectorXd::LinSpaced(rows_of(part), -1.0 - static_cast<double>(k), 2.0);
        const MatrixXd answers = factor.solve(loads);
        for (Index k = 0; k < columns; ++k)
            EXPECT_EQ((answers.col(k) - factor.solve(loads.col(k))).norm(), 0.0) << k;
    }
}

}  // namespace
}  // namespace stridor::reduction
