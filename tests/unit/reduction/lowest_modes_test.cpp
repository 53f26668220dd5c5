#include "stridor/reduction/lowest_modes.hpp"

#include "support/error_text.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace stridor::reduction {
namespace {

using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;
using support::thrown_by;

double chain_squared(int masses, double spring, double mass, int mode) {
    const double sine = std::sin((2 * mode - 1) * std::numbers::pi / (2.0 * (2.0 * masses + 1.0)));
    return 4.0 * spring / mass * sine * sine;
}

// K x - omega^2 M x, in the measure of M^-1's diagonal
void expect_modes(const ElasticPart& part, const Modes& modes) {
    for (Eigen::Index k = 0; k < modes.squared.size(); ++k) {
        const Eigen::VectorXd x = modes.shapes.col(k);
        const Eigen::VectorXd left = part.stiffness * x - modes.squared[k] * (part.mass * x);
        EXPECT_LT(left.norm(), 1e-9 * (part.stiffness * x).norm() + 1e-8 * part.stiffness.norm() * x.norm()) << k;
        EXPECT_NEAR(x.dot(part.mass * x), 1.0, 1e-12) << k;
        if (k > 0) {
            EXPECT_NEAR(x.dot(part.mass * modes.shapes.col(k - 1)), 0.0, 1e-9) << k;
        }
    }
}

TEST(LowestModes, OfAChainAreItsClosedForm) {
    for (const int masses : {1, 2, 7, 400}) {
        const ElasticPart part = chain_part(masses, 3e5, 0.02);
        const Modes modes = lowest_modes(part.stiffness, part.mass, std::min(masses, 12));
        ASSERT_EQ(modes.squared.size(), std::min(masses, 12));
        for (int mode = 1; mode <= modes.squared.size(); ++mode)
            // the condition of the chain, 4 (n/pi)^2 at the lowest, times rounding
            EXPECT_NEAR(modes.squared[mode - 1] / chain_squared(masses, 3e5, 0.02, mode), 1.0, 1e-10) << masses;
        expect_modes(part, modes);
    }
}

// powers of two are exact, so that the bits are those of other units
TEST(LowestModes, AreTheSameInAnyUnits) {
    const ElasticPart part = chain_part(400, 3e5, 0.02);
    const Modes modes = lowest_modes(part.stiffness, part.mass, 12);
    for (const int power : {-80, -40, 40, 80}) {
        const double unit = std::ldexp(1.0, power);
        const Modes scaled = lowest_modes(unit * part.stiffness, part.mass, 12);
        EXPECT_EQ(scaled.squared, unit * modes.squared) << power;
        EXPECT_EQ(scaled.shapes, modes.shapes) << power;
    }
}

TEST(LowestModes, AreAsManyAsThereAre) {
    const ElasticPart part = chain_part(5, 1.0, 1.0);
    EXPECT_EQ(lowest_modes(part.stiffness, part.mass, 50).squared.size(), 5);
    EXPECT_EQ(lowest_modes(part.stiffness, part.mass, 0).squared.size(), 0);
}

TEST(LowestModes, OfAFreeSolidBeginWithSixRigidBodyModes) {
    const ElasticPart part = lattice_part({4, 4, 3}, LatticeSupport::free);
    const Modes modes = lowest_modes(part.stiffness, part.mass, 10);
    ASSERT_EQ(modes.squared.size(), 10);
    for (int k = 0; k < 6; ++k)
        EXPECT_LT(std::abs(modes.squared[k]), 1e-8 * modes.squared[6]) << k;
    EXPECT_GT(modes.squared[6], 1.0);
    expect_modes(part, modes);
}

// a starting vector of Lanczos holds one combination only of the shapes of one frequency
TEST(LowestModes, MissNoneOfThoseThatComeSeveralTimes) {
    constexpr int copies = 6;
    const ElasticPart one = lattice_part({3, 3, 4}, LatticeSupport::top_held);
    const Eigen::Index rows = rows_of(one);
    const auto repeated = [&](const SparseMatrix& matrix) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index column = 0; column < rows; ++column)
            for (int copy = 0; copy < copies; ++copy)
                for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
                    entries.emplace_back(entry.row() + copy * rows, column + copy * rows, entry.value());
        SparseMatrix all(copies * rows, copies * rows);
        all.setFromTriplets(entries.begin(), entries.end());
        return all;
    };
    const Modes single = lowest_modes(one.stiffness, one.mass, 4);
    const Modes all = lowest_modes(repeated(one.stiffness), repeated(one.mass), 3 * copies);
    ASSERT_EQ(all.squared.size(), 3 * copies);
    for (int mode = 0; mode < 3 * copies; ++mode)
        EXPECT_NEAR(all.squared[mode] / single.squared[mode / copies], 1.0, 1e-9) << mode;
}

TEST(LowestModes, LeaveOutMotionsWithoutMass) {
    for (const int masses : {8, 100}) {
        ElasticPart part = chain_part(masses, 1e4, 0.1);
        for (int row = 0; row < masses; row += 2)
            part.mass.coeffRef(row, row) = 0.0;
        const Modes modes = lowest_modes(part.stiffness, part.mass, 4);
        ASSERT_EQ(modes.squared.size(), 4);
        expect_modes(part, modes);
        // two springs between masses that are left: half the stiffness, one mass for two
        EXPECT_NEAR(modes.squared[0] / chain_squared(masses / 2, 0.5e4, 0.1, 1), 1.0, 1e-9);
    }
    ElasticPart part = chain_part(8, 1e4, 0.1);
    for (int row = 0; row < 8; row += 2)
        part.mass.coeffRef(row, row) = 0.0;
    EXPECT_EQ(lowest_modes(part.stiffness, part.mass, 8).squared.size(), 4);
    EXPECT_EQ(highest_squared(part.stiffness, part.mass), std::numeric_limits<double>::infinity());
}

TEST(LowestModes, RefuseAStiffnessThatBuckles) {
    ElasticPart part = chain_part(4, 1.0, 1.0);
    part.stiffness.coeffRef(0, 0) = -1e3;
    EXPECT_TRUE(thrown_by([&] { lowest_modes(part.stiffness, part.mass, 2); }).says("negative for some motion"));
}

TEST(ModesBelow, AreCountedByInertia) {
    const ElasticPart part = chain_part(300, 1e6, 1.0);
    for (const int mode : {1, 5, 77, 300}) {
        const double frequency = frequency_of(chain_squared(300, 1e6, 1.0, mode));
        EXPECT_EQ(modes_below(part.stiffness, part.mass, frequency * (1.0 - 1e-7)), mode - 1);
        EXPECT_EQ(modes_below(part.stiffness, part.mass, frequency * (1.0 + 1e-7)), mode);
    }
}

TEST(HighestSquared, OfAChainIsItsClosedForm) {
    for (const int masses : {6, 200}) {
        const ElasticPart part = chain_part(masses, 1e6, 1.0);
        EXPECT_NEAR(highest_squared(part.stiffness, part.mass) / chain_squared(masses, 1e6, 1.0, masses), 1.0, 1e-4);
    }
}

}  // namespace
}  // namespace stridor::reduction
