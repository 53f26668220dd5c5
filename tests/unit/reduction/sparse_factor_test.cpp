#include "stridor/reduction/sparse_factor.hpp"

#include "stridor/base/error.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/least_fill.hpp"
#include "stridor/reduction/part_contacts.hpp"
#include "stridor/reduction/part_figures.hpp"
#include "support/error_text.hpp"
#include "support/needs.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace stridor::reduction {
namespace {

using Eigen::Index;
using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;
using support::Thrown;
using support::thrown_by;

std::vector<int> order_of(const SparseMatrix& matrix) {
    LeastFill::PermutationType order;
    LeastFill()(matrix, order);
    return {order.indices().data(), order.indices().data() + order.size()};
}

TEST(LeastFill, OrdersEachRowOnceAndAlwaysTheSame) {
    // on either side of the size from which nested dissection takes over
    for (const int layers : {3, 19}) {
        const ElasticPart part = lattice_part({10, 10, layers}, LatticeSupport::free);
        const std::vector<int> order = order_of(part.stiffness);
        EXPECT_EQ(order, order_of(part.stiffness));
        std::vector<int> sorted = order;
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> rows(static_cast<std::size_t>(rows_of(part)));
        std::iota(rows.begin(), rows.end(), 0);
        EXPECT_EQ(sorted, rows);
    }
}

TEST(LeastFill, IsTheSameBesideOthers) {
    const ElasticPart part = lattice_part({12, 12, 13}, LatticeSupport::free);
    const std::vector<int> alone = order_of(part.stiffness);
    std::vector<int> first;
    std::thread other([&] { first = order_of(part.stiffness); });
    const std::vector<int> second = order_of(part.stiffness);
    other.join();
    EXPECT_EQ(first, alone);
    EXPECT_EQ(second, alone);
}

// the order of a machine is that of every other: these are Debian's METIS 5.1 and Eigen 3.4
TEST(LeastFill, HasTheOrderThatItEverHad) {
    const auto fingerprint = [](const SparseMatrix& matrix) {
        std::uint64_t hash = 14695981039346656037U;  // FNV-1a
        for (const int row : order_of(matrix))
            hash = (hash ^ static_cast<std::uint64_t>(row)) * 1099511628211U;
        return hash;
    };
    EXPECT_EQ(fingerprint(lattice_part({6, 6, 6}, LatticeSupport::free).stiffness), 5471184207972409485U);
    EXPECT_EQ(fingerprint(lattice_part({12, 12, 13}, LatticeSupport::free).stiffness), 16182519947640513123U);
}

TEST(SparseFactor, OfALargePartSolvesAndCounts) {
    const ElasticPart part = lattice_part({12, 12, 14}, LatticeSupport::top_held);
    ASSERT_GT(rows_of(part), LeastFill::few_rows);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(rows_of(part), -1.0, 2.0);
    const SparseFactor held(part.stiffness, part.mass, 0.0);
    EXPECT_EQ(held.negative_pivots(), 0);
    EXPECT_LT((part.stiffness * held.solve(load) - load).norm(), 1e-10 * load.norm());
    const Modes modes = lowest_modes(part.stiffness, part.mass, 4);
    const double between = 0.5 * (modes.squared[2] + modes.squared[3]);
    EXPECT_EQ(SparseFactor(part.stiffness, part.mass, between).negative_pivots(), 3);
}

TEST(WithoutZeros, LeavesTheRest) {
    SparseMatrix matrix(2, 2);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, 2.0}, {1, 0, 0.0}, {0, 1, -0.0}, {1, 1, 1e-300}};
    matrix.setFromTriplets(entries.begin(), entries.end());
    EXPECT_EQ(without_zeros(matrix).nonZeros(), 2);
    EXPECT_EQ(Eigen::MatrixXd(without_zeros(matrix)), Eigen::MatrixXd(matrix));
}

// Of a build or a machine without MUMPS one thing is asked: that it says so.
class Mumps : public testing::Test {
protected:
    void SetUp() override {
        const ElasticPart part = chain_part(2, 1.0, 1.0);
        std::string refusal;
        try {
            SparseFactor(part.stiffness, part.mass, 0.0, LinearSolver::mumps);
        } catch (const Error& error) {
            refusal = error.what();
            EXPECT_NE(refusal.find("MUMPS"), std::string::npos) << refusal;
            EXPECT_NE(refusal.find("libmumps-seq-5.5"), std::string::npos) << refusal;
        }
        STRIDOR_NEEDS(refusal.empty(), "MUMPS", "libmumps-headers-dev libmumps-seq-5.5");
    }
};

TEST_F(Mumps, FindsTheFrequenciesThatEigenFinds) {
    for (const LatticeSupport support : {LatticeSupport::top_held, LatticeSupport::free}) {
        const ElasticPart part = lattice_part({7, 6, 8}, support);
        const Modes own = lowest_modes(part.stiffness, part.mass, 14);
        const Modes other = lowest_modes(part.stiffness, part.mass, 14, LinearSolver::mumps);
        ASSERT_EQ(other.squared.size(), own.squared.size());
        const Index rigid = support == LatticeSupport::free ? 6 : 0;
        for (Index k = rigid; k < own.squared.size(); ++k)
            EXPECT_NEAR(std::sqrt(other.squared[k] / own.squared[k]), 1.0, 1e-9) << k;
        for (Index k = 0; k < rigid; ++k)
            EXPECT_LT(std::abs(other.squared[k]), 1e-8 * own.squared[6]) << k;
    }
}

TEST_F(Mumps, CountsAsManyModesBelowAFrequency) {
    const ElasticPart part = lattice_part({6, 5, 7}, LatticeSupport::free);
    const Modes modes = lowest_modes(part.stiffness, part.mass, 30);
    for (Index k = 6; k + 1 < modes.squared.size(); ++k) {
        if (modes.squared[k + 1] < 1.001 * modes.squared[k]) continue;
        const double between = frequency_of(0.5 * (modes.squared[k] + modes.squared[k + 1]));
        EXPECT_EQ(modes_below(part.stiffness, part.mass, between, LinearSolver::mumps), k + 1);
        EXPECT_EQ(modes_below(part.stiffness, part.mass, between), k + 1);
    }
}

TEST_F(Mumps, SolvesManyRightSides) {
    const ElasticPart part = lattice_part({5, 4, 6}, LatticeSupport::top_held);
    const Eigen::MatrixXd loads = Eigen::MatrixXd::Identity(rows_of(part), 11);
    const SparseFactor factor(part.stiffness, part.mass, 0.0, LinearSolver::mumps);
    EXPECT_LT((part.stiffness * factor.solve(loads) - loads).norm(), 1e-10);
    EXPECT_EQ(factor.solve(Eigen::MatrixXd(rows_of(part), 0)).cols(), 0);
}

TEST_F(Mumps, ReducesToTheSamePart) {
    const ElasticPart part = lattice_part({6, 5, 7}, LatticeSupport::top_held);
    const ReductionRequest request{.boundary = named_rows(part, "FOOT"), .modes = 12};
    const Reduction own = craig_bampton(CondensedPart(part, request.boundary), request);
    const Reduction other = craig_bampton(CondensedPart(part, request.boundary, LinearSolver::mumps), request);
    EXPECT_EQ(own.solver, LinearSolver::eigen);
    EXPECT_EQ(other.solver, LinearSolver::mumps);
    ASSERT_EQ(other.mode_frequencies.size(), own.mode_frequencies.size());
    for (std::size_t k = 0; k < own.mode_frequencies.size(); ++k)
        EXPECT_NEAR(other.mode_frequencies[k] / own.mode_frequencies[k], 1.0, 1e-9) << k;
    const Eigen::MatrixXd difference = Eigen::MatrixXd(own.part.stiffness) - Eigen::MatrixXd(other.part.stiffness);
    EXPECT_LT(difference.norm(), 1e-9 * own.part.stiffness.norm());
}

// what one refuses, the other refuses in the same words
void expect_same_refusal(const std::function<void(LinearSolver)>& attempt, const std::string& sentence) {
    const Thrown own = thrown_by([&] { attempt(LinearSolver::eigen); });
    const Thrown other = thrown_by([&] { attempt(LinearSolver::mumps); });
    EXPECT_TRUE(own.says(sentence)) << own.message;
    EXPECT_EQ(other.message, own.message);
    EXPECT_EQ(other.kind, own.kind);
}

TEST_F(Mumps, RefusesInTheWordsOfEigen) {
    const ElasticPart free = lattice_part({4, 4, 5}, LatticeSupport::free);
    expect_same_refusal([&](LinearSolver by) { CondensedPart(free, {0, 1, 2}, by); }, "does not hold the part");

    ElasticPart buckling = chain_part(100, 1.0, 1.0);
    buckling.stiffness.coeffRef(50, 50) = -5.0;
    expect_same_refusal([&](LinearSolver by) { lowest_modes(buckling.stiffness, buckling.mass, 5, by); },
                        "negative for some motion");
    expect_same_refusal([&](LinearSolver by) { CondensedPart(buckling, {0}, by); }, "does not hold the part");

    ElasticPart light = chain_part(100, 1.0, 1.0);
    light.mass.coeffRef(3, 4) = 2.0;
    light.mass.coeffRef(4, 3) = 2.0;
    expect_same_refusal([&](LinearSolver by) { expect_sound(light, by); }, "the mass is negative for some motion");
}

TEST_F(Mumps, KnowsAPartThatIsHeldWeaklyFromAFreeOne) {
    const ElasticPart free = lattice_part({4, 4, 5}, LatticeSupport::free);
    EXPECT_LT(SparseFactor(free.stiffness, free.mass, 0.0, LinearSolver::mumps).weakest_pivot(), 1e-13);
    for (const double spring : {1e-2, 1e-5}) {  // [1] of the diagonal
        SparseMatrix held = free.stiffness;
        for (const Index row : {0, 1, 2, 25, 50, 74})
            held.coeffRef(row, row) *= 1.0 + spring;
        const double own = SparseFactor(held, free.mass, 0.0).weakest_pivot();
        const double other = SparseFactor(held, free.mass, 0.0, LinearSolver::mumps).weakest_pivot();
        EXPECT_GT(other, 1e-2 * own) << spring;
        EXPECT_LT(other, 1e2 * own) << spring;
    }
}

TEST_F(Mumps, GivesTheFiguresThatEigenGives) {
    const ElasticPart part = lattice_part({5, 4, 6}, LatticeSupport::free);
    const PartVibration own = part_vibration(part, 6);
    const PartVibration other = part_vibration(part, 6, LinearSolver::mumps);
    EXPECT_EQ(other.rigid_body_modes, own.rigid_body_modes);
    EXPECT_NEAR(other.highest_frequency / own.highest_frequency, 1.0, 1e-6);
    for (std::size_t k = 0; k < own.frequencies.size(); ++k)
        EXPECT_NEAR(other.frequencies.at(k) / own.frequencies[k], 1.0, 1e-9) << k;
    const auto contacts = part_contacts(part, named_rows(part, "FOOT"), 3);
    const auto others = part_contacts(part, named_rows(part, "FOOT"), 3, LinearSolver::mumps);
    ASSERT_TRUE(contacts && others);
    EXPECT_NEAR(others->shared_inertia, contacts->shared_inertia, 1e-9);
}

}  // namespace
}  // namespace stridor::reduction
