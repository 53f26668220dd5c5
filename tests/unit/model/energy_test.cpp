#include "stridor/model/energy.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"

#include <gtest/gtest.h>

namespace stridor::model {
namespace {

TEST(Energy, OfTheBeltOscillatorIsTheTextbooks) {
    const auto structure = mass_on_belt({2.0, 500.0, 0.0, 7.0, {}});
    EXPECT_EQ(kinetic_energy(structure.mass, Eigen::Vector2d(3.0, 4.0)), 25.0);  // 2 (9 + 16) / 2
    EXPECT_EQ(elastic_energy(structure.stiffness, Eigen::Vector2d(0.2, 99.0)),
              10.0);  // 500 0.04 / 2, none across the belt
}

// along its axis the joint has the axial stiffness, across it the flexural one
TEST(Energy, OfTheJointFollowsItsAxis) {
    parameters::Case c;
    const auto structure = rubbing_system(c);
    constexpr double cosine = 0.3420201433256687, sine = 0.9396926207859084;  // of 70 degrees
    EXPECT_NEAR(elastic_energy(structure.stiffness, Eigen::Vector3d(cosine, sine, 0.0)), 0.5e7, 0.5e7 * 1e-14);
    // (k1i - k1j) cancels: rounding of k1i
    EXPECT_NEAR(elastic_energy(structure.stiffness, Eigen::Vector3d(-sine, cosine, 0.0)), 0.5e6, 0.5e7 * 1e-14);
}

}  // namespace
}  // namespace stridor::model
