#include "stridor/model/coulomb.hpp"

#include <gtest/gtest.h>

namespace stridor::model {
namespace {

constexpr Coulomb friction{0.8, 0.2};

TEST(Coulomb, StickLimitIsStaticFrictionOfAClosedContact) {
    EXPECT_EQ(stick_limit(friction, 20.0), 16.0);
    EXPECT_EQ(stick_limit(friction, 0.0), 0.0);
    EXPECT_EQ(stick_limit(friction, -20.0), 0.0);
}

TEST(Coulomb, SlipForceOpposesTheSlipVelocity) {
    EXPECT_EQ(slip_force(friction, 20.0, 1.0), -4.0);
    EXPECT_EQ(slip_force(friction, 20.0, -1e-300), 4.0);
}

TEST(Coulomb, SlipForceVanishesWithoutSlipOrContact) {
    EXPECT_EQ(slip_force(friction, 20.0, 0.0), 0.0);
    EXPECT_EQ(slip_force(friction, 0.0, 1.0), 0.0);
    EXPECT_EQ(slip_force(friction, -20.0, 1.0), 0.0);
}

}  // namespace
}  // namespace stridor::model
