#include "stridor/reduction/craig_bampton.hpp"

#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/reduction_errors.hpp"
#include "support/error_text.hpp"
#include "support/structures/lattice_part.hpp"
#include "unit/reduction/worst_error.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace stridor::reduction {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;
using support::thrown_by;

ElasticPart block() {
    return lattice_part({4, 3, 4}, LatticeSupport::top_held);
}

ReductionRequest foot(const ElasticPart& part, Index modes, BoundaryInertia inertia = BoundaryInertia::consistent) {
    return {.boundary = named_rows(part, "FOOT"), .modes = modes, .inertia = inertia};
}

TEST(CraigBampton, WithAllModesIsTheFullPart) {
    const ElasticPart part = block();
    const ReductionRequest request = foot(part, 1000);
    const Reduction reduction = craig_bampton(part, request);
    EXPECT_EQ(rows_of(reduction.part), rows_of(part));
    EXPECT_NO_THROW(expect_sound(reduction.part));
    const auto errors = reduction_errors({part, request.boundary}, reduction, contact_states(reduction, 3), 6);
    ASSERT_EQ(errors.states.size(), 2U);
    for (const StateErrors& state : errors.states) {
        EXPECT_EQ(state.frequencies.size(), 6U);
        EXPECT_LT(worst_error(state), 1e-10) << state.name;
    }
}

TEST(CraigBampton, IsExactInStaticsWhateverIsKept) {
    const ElasticPart part = block();
    for (const Index modes : {0, 3, 12})
        for (const BoundaryInertia inertia : {BoundaryInertia::consistent, BoundaryInertia::lumped}) {
            const ReductionRequest request = foot(part, modes, inertia);
            const auto errors =
                reduction_errors({part, request.boundary}, craig_bampton(part, request), {{"open", {}}}, 1);
            ASSERT_TRUE(errors.flexibility);
            EXPECT_LT(*errors.flexibility, 1e-12);
        }
}

// Ritz: frequencies come from above, and come down as modes are added
TEST(CraigBampton, ComesCloserFromAboveWithEachMode) {
    const ElasticPart part = block();
    double before = 1.0;
    for (const Index modes : {0, 6, 20}) {
        const ReductionRequest request = foot(part, modes);
        const Reduction reduction = craig_bampton(part, request);
        const auto errors = reduction_errors({part, request.boundary}, reduction, contact_states(reduction, 3), 3);
        for (const FrequencyPair& pair : errors.states.front().frequencies)
            EXPECT_GT(relative_error(pair), -1e-12);
        EXPECT_LT(worst_error(errors.states.front()), 0.5 * before) << modes;
        before = worst_error(errors.states.front());
    }
    EXPECT_LT(before, 2e-3);
}

TEST(CraigBampton, HasFixedInterfaceModesOfUnitMass) {
    const ElasticPart part = block();
    const Reduction reduction = craig_bampton(part, foot(part, 5));
    const MatrixXd stiffness(reduction.part.stiffness);
    const MatrixXd mass(reduction.part.mass);
    EXPECT_EQ(reduction.boundary_rows, 36);
    EXPECT_EQ(describe(reduction.part.labels[0]), "100.1");
    EXPECT_EQ(describe(reduction.part.labels[36]), "mode 1");
    EXPECT_EQ(stiffness.topRightCorner(36, 5).norm(), 0.0);
    EXPECT_LT((mass.bottomRightCorner(5, 5) - MatrixXd::Identity(5, 5)).norm(), 1e-15);
    for (int mode = 0; mode < 5; ++mode)
        EXPECT_NEAR(
            stiffness(36 + mode, 36 + mode) / squared_of(reduction.mode_frequencies.at(static_cast<std::size_t>(mode))),
            1.0, 1e-13);
}

// an impact at one node leaves its neighbours alone, and every direction keeps the mass behind the modes
TEST(CraigBampton, LumpsTheContactInertia) {
    const ElasticPart part = block();
    const Reduction consistent = craig_bampton(part, foot(part, 6));
    const Reduction lumped = craig_bampton(part, foot(part, 6, BoundaryInertia::lumped));
    const auto inertia = [](const Reduction& reduction) {  // the inverse of W
        return MatrixXd(MatrixXd(reduction.part.mass).inverse().topLeftCorner(36, 36).inverse());
    };
    const MatrixXd full = inertia(consistent);
    const MatrixXd diagonal = inertia(lumped);
    EXPECT_LT((diagonal - MatrixXd(diagonal.diagonal().asDiagonal())).cwiseAbs().maxCoeff(),
              1e-12 * diagonal.maxCoeff());
    EXPECT_GT((full - MatrixXd(full.diagonal().asDiagonal())).cwiseAbs().maxCoeff(), 0.05 * full.maxCoeff());
    for (int component = 0; component < 3; ++component) {
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(36);
        for (Index row = component; row < 36; row += 3)
            motion[row] = 1.0;
        EXPECT_NEAR(motion.dot(diagonal * motion) / motion.dot(full * motion), 1.0, 1e-12);
    }
    EXPECT_NO_THROW(expect_sound(lumped.part));
    const ReductionRequest request = foot(part, 6);
    EXPECT_GT(reduction_errors({part, request.boundary}, consistent, {}, 1).coupling, 0.05);
    EXPECT_LT(reduction_errors({part, request.boundary}, lumped, {}, 1).coupling, 1e-12);
}

TEST(CraigBampton, RecoversTheMotionOfOtherRows) {
    const ElasticPart part = block();
    ReductionRequest request = foot(part, 4);
    request.recovered = {60, 75, 0};
    const Reduction reduction = craig_bampton(part, request);
    ASSERT_EQ(reduction.recovery.rows(), 3);
    EXPECT_EQ(describe(reduction.recovered[1]), describe(part.labels[75]));
    // a static load on the boundary
    Eigen::VectorXd load = Eigen::VectorXd::Zero(rows_of(part));
    load[5] = 10.0;
    const Eigen::VectorXd exact = Eigen::SimplicialLDLT<SparseMatrix>(part.stiffness).solve(load);
    const Eigen::VectorXd reduced =
        Eigen::SimplicialLDLT<SparseMatrix>(reduction.part.stiffness).solve(load.head(rows_of(reduction.part)));
    const Eigen::VectorXd recovered = reduction.recovery * reduced;
    for (const Index k : {0, 1, 2})
        EXPECT_NEAR(recovered[k] / exact[request.recovered[static_cast<std::size_t>(k)]], 1.0, 1e-11);
}

TEST(CraigBampton, ProjectsADamping) {
    ElasticPart part = block();
    part.damping = 1e-5 * part.stiffness + 3.0 * part.mass;
    const Reduction reduction = craig_bampton(part, foot(part, 7));
    const SparseMatrix wanted = 1e-5 * reduction.part.stiffness + 3.0 * reduction.part.mass;
    EXPECT_LT((reduction.part.damping - wanted).norm(), 1e-11 * wanted.norm());
}

TEST(CraigBampton, KeepsPlacesAndSetsOfItsRows) {
    const ElasticPart part = block();
    const Reduction reduction = craig_bampton(part, foot(part, 2));
    EXPECT_EQ(reduction.part.positions.size(), 12U);
    ASSERT_EQ(reduction.part.sets.size(), 1U);
    EXPECT_EQ(reduction.part.sets[0].nodes.size(), 12U);
}

TEST(CraigBampton, KeepsAllModesBelowAFrequency) {
    const ElasticPart part = block();
    const auto all = craig_bampton(part, foot(part, 30)).mode_frequencies;
    ReductionRequest request = foot(part, 0);
    request.below = 0.5 * (all[10] + all[11]);
    EXPECT_EQ(craig_bampton(part, request).mode_frequencies.size(), 11U);
}

TEST(CraigBampton, OfAFreePartNeedsABoundaryThatHoldsIt) {
    const ElasticPart part = lattice_part({4, 3, 4}, LatticeSupport::free);
    const Reduction reduction = craig_bampton(part, foot(part, 6));
    EXPECT_FALSE(reduction_errors({part, foot(part, 6).boundary}, reduction, {{"open", {}}}, 1).flexibility);
    EXPECT_TRUE(thrown_by([&] {
                    craig_bampton(part, {.boundary = {0, 1, 2}, .modes = 2});
                }).says("the boundary does not hold the part"));
}

TEST(CraigBampton, RefusesToLeaveDoublePrecision) {
    const auto thrown = thrown_by([] { craig_bampton(chain_part(6, 1e-160, 1e160), {.boundary = {5}, .modes = 3}); });
    EXPECT_EQ(thrown.kind, ErrorKind::numerical);
}

TEST(CraigBampton, RefusesABoundaryThatIsNone) {
    const ElasticPart part = chain_part(6, 1.0, 1.0);
    EXPECT_TRUE(thrown_by([&] { craig_bampton(part, {.modes = 2}); }).says("the boundary is empty"));
    EXPECT_TRUE(thrown_by([&] {
                    craig_bampton(part, {.boundary = {2, 2}});
                }).says("row 3.1 stands twice in the boundary"));
}

TEST(CraigBampton, OfABoundaryOfAllRowsIsThePartItself) {
    const ElasticPart part = chain_part(3, 2.0, 0.5);
    const Reduction reduction =
        craig_bampton(part, {.boundary = {0, 1, 2}, .modes = 4, .inertia = BoundaryInertia::consistent});
    EXPECT_EQ((reduction.part.stiffness - part.stiffness).norm(), 0.0);
    EXPECT_EQ((reduction.part.mass - part.mass).norm(), 0.0);
}

}  // namespace
}  // namespace stridor::reduction
