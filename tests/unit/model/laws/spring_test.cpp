#include "stridor/model/laws/spring.hpp"

#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/contact/static_contact.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace stridor::model {
namespace {

using parameters::Interpolation;

const std::vector<double> spring_rows{-1.0, 0.0, 0.5, 2.0, 2.5};
const std::vector<double> row_forces{-3.0, 0.0, 0.0, 4.0, 9.0};

std::vector<SpringLaw> all_spring_laws() {
    return {CubicSpring{3.0},
            CubicSpring{-0.5},
            power_spring(2.0, 0.3, 1.5, 0.1, 0.0),
            power_spring(2.0, 0.3, 1.7, -0.2, 5.0),
            power_spring(2.0, 0.3, 1.0, 0.1, 0.0),
            power_spring(2.0, 0.3, 2.0, 0.1, 0.0),
            power_spring(2.0, 0.3, 3.0, 0.1, 0.0),
            table_spring(spring_rows, row_forces, Interpolation::cubic),
            table_spring(spring_rows, row_forces, Interpolation::linear)};
}

// central differences of a smooth function: O(h²), and rounding/h
TEST(SpringLaw, HasTheSlopeOfItsForceAndTheForceOfItsEnergy) {
    const double h = 1e-5;
    for (const SpringLaw& law : all_spring_laws())
        for (const double e : {-1.7, -0.6, -0.05, 0.2, 0.31, 0.75, 1.3, 2.2, 3.1}) {
            const double slope = (force_of(law, e + h) - force_of(law, e - h)) / (2.0 * h);
            const double force = (energy_of(law, e + h) - energy_of(law, e - h)) / (2.0 * h);
            EXPECT_NEAR(stiffness_of(law, e), slope, 1e-7 * (1.0 + std::abs(slope))) << law.index() << " " << e;
            EXPECT_NEAR(force_of(law, e), force, 1e-7 * (1.0 + std::abs(force))) << law.index() << " " << e;
        }
}

TEST(SpringLaw, IsContinuousAtItsCorners) {
    for (const SpringLaw& law : all_spring_laws())
        for (const double corner :
             std::visit([](const auto& each) { return std::vector<double>(each.corners()); }, law)) {
            const double below = std::nextafter(corner, -10.0), above = std::nextafter(corner, 10.0);
            EXPECT_NEAR(force_of(law, below), force_of(law, above), 1e-13);
            EXPECT_NEAR(energy_of(law, below), energy_of(law, above), 1e-13);
        }
}

TEST(PowerSpring, GoesOnWithItsSlopeWhereItIsBlunt) {
    const PowerSpring law = power_spring(2.0, 0.3, 1.5, 0.1, 5.0);
    const double end = law.gap + law.blunt;
    const double before = law.stiffness(end - 1e-9 * law.blunt), behind = law.stiffness(end + 1e-9 * law.blunt);
    EXPECT_NEAR(before, behind, 1e-6 * behind);
    // a millionth of the deflection under 5 N
    EXPECT_NEAR(law.blunt, 1e-6 * 0.3 * std::pow(2.5, 1.0 / 1.5), 1e-18);
    EXPECT_EQ(law.force(law.gap - 1.0), 0.0);
    EXPECT_NEAR(law.force(law.gap + 0.3), 2.0, 1e-14);
}

// along e = e0 + a t + b t², by sums of the coefficients at t
TEST(SpringLaw, HasTheJetOfItsForceAlongAMotion) {
    for (const SpringLaw& law : all_spring_laws())
        for (const double start : {-1.4, -0.7, 0.04, 0.25, 1.1, 2.2, 3.0})
            for (const double rate : {0.02, -0.03}) {
                const std::vector<double> motion{start, rate, 0.004};
                std::vector<double> elongation(20, 0.0);
                std::copy(motion.begin(), motion.end(), elongation.begin());
                SpringTerms terms;
                terms.stretch = elongation_stretch(law, start, 0.0, rate > 0.0 ? CornerSide::above : CornerSide::below);
                const double t = 0.5;
                double force = 0.0, power = 1.0, e = 0.0;
                for (std::size_t m = 0; m < elongation.size(); ++m) {
                    terms.elongation = std::span(elongation).first(m + 1);
                    force += next_force(law, terms) * power;
                    e += elongation[m] * power;
                    power *= t;
                }
                ASSERT_GE(e, terms.stretch.from);
                ASSERT_LE(e, terms.stretch.to);
                EXPECT_NEAR(force, force_of(law, e), 1e-13 * (1.0 + std::abs(force))) << law.index() << " " << start;
            }
}

TEST(SpringLaw, IsFoundByTheForceItPushesWith) {
    for (const SpringLaw& law : all_spring_laws()) {
        if (law == SpringLaw(CubicSpring{-0.5})) continue;
        for (const double force : {0.0, 0.3, 7.0}) {
            const double e = elongation_under(law, 0.2, force);
            EXPECT_NEAR(force_of(law, e) + 0.2 * e, force, 1e-13 * (1.0 + force)) << law.index();
        }
    }
    EXPECT_TRUE(std::isinf(elongation_under(CubicSpring{-0.5}, 0.0, 1.0)));
}

// a mass that hangs on K and Hertz' spring: k e + F(e) = P, from far away and from above a gap
TEST(Equilibrium, WithSpringsBalancesForces) {
    for (const SpringLaw& law : all_spring_laws()) {
        if (law == SpringLaw(CubicSpring{-0.5})) continue;
        for (const double load : {-2.0, 0.5, 30.0, 1e4}) {
            Structure structure = structure_of_size(2);
            structure.stiffness << 1.5, 0.0, 0.0, 1.0;
            structure.contacts.front().normal = Eigen::Vector2d(0.0, 1.0);
            structure.contacts.front().tangent = Eigen::Vector2d(1.0, 0.0);
            structure.load = Eigen::Vector2d(load, -3.0);
            structure.springs.push_back({Eigen::Vector2d(1.0, 0.0), law, 0.02});
            const Equilibrium found = equilibrium(structure, {0.0});
            const double x = found.displacement(0);
            EXPECT_NEAR(1.5 * x + force_of(law, 0.02 + x), load, 1e-12 * (1.0 + std::abs(load))) << law.index();
            EXPECT_NEAR(found.normal_forces(0), 3.0, 1e-13);
            const Equilibrium rest = static_contact(structure);
            EXPECT_NEAR(rest.displacement(0), x, 1e-12 * (1.0 + std::abs(x))) << law.index();
            EXPECT_NEAR(rest.normal_forces(0), 3.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace stridor::model
