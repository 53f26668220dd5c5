#include "stridor/model/built/mass_on_belt.hpp"

#include "stridor/model/contact/contact_forces.hpp"

#include <gtest/gtest.h>

namespace stridor::model {
namespace {

const Belt damped_belt{2.0, 500.0, 3.0, 7.0, {0.8, 0.3}};

TEST(MassOnBelt, HasItsSpringAndDashpotAlongTheBeltOnly) {
    const auto structure = mass_on_belt(damped_belt);
    EXPECT_EQ(structure.mass, (Eigen::Matrix2d{{2.0, 0.0}, {0.0, 2.0}}));
    EXPECT_EQ(structure.stiffness, (Eigen::Matrix2d{{500.0, 0.0}, {0.0, 0.0}}));
    EXPECT_EQ(structure.damping, (Eigen::Matrix2d{{3.0, 0.0}, {0.0, 0.0}}));
}

// whatever the mass does along the damped_belt, N = F
TEST(MassOnBelt, IsPressedByThePreloadAlways) {
    const auto structure = mass_on_belt(damped_belt);
    for (const double x : {-0.1, 0.0, 0.02})
        for (const double speed : {-1.0, 0.0, 0.5})
            EXPECT_NEAR(
                instant(structure, Eigen::Vector2d(x, 0.0), Eigen::Vector2d(speed, 0.0), {0.3, 0.0}).normal_force, 7.0,
                1e-14);
}

}  // namespace
}  // namespace stridor::model
