#include "stridor/integration/run/imposed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stridor::integration {
namespace {

parameters::Drive shaker() {
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::force;
    drive.force = 3.0;
    drive.frequency = 7.0;
    drive.ramp = 0.05;
    return drive;
}

TEST(ImposedForce, IsACosineOnceItHasGrown) {
    for (const double time : {0.05, 0.1, 0.333, 12.5})
        EXPECT_NEAR(imposed_force(shaker(), time), 3.0 * std::cos(2.0 * std::numbers::pi * 7.0 * time), 1e-12) << time;
}

TEST(ImposedForce, GrowsByHalfACosine) {
    EXPECT_EQ(imposed_force(shaker(), 0.0), 0.0);
    for (const double time : {0.01, 0.025, 0.04}) {
        const double grown = 0.5 * (1.0 - std::cos(std::numbers::pi * time / 0.05));
        EXPECT_NEAR(imposed_force(shaker(), time), 3.0 * grown * std::cos(2.0 * std::numbers::pi * 7.0 * time), 1e-12);
    }
}

TEST(ImposedForce, IsNoneOfASurfaceThatMoves) {
    parameters::Drive drive = shaker();
    drive.kind = parameters::DriveKind::sinusoidal;
    EXPECT_EQ(imposed_force(drive, 0.1), 0.0);
}

}  // namespace
}  // namespace stridor::integration
