#include "stridor/integration/run/motion.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::integration {
namespace {

TEST(EnergyBalance, ResidualIsAShareOfAllThatWentInOrOut) {
    const EnergyBalance balance{-1.0, -2.0, 4.0, 1.0, 2.0, 6.0, 0.4};
    EXPECT_DOUBLE_EQ(balance.relative_residual(), 0.4 / 16.0);
}

TEST(EnergyBalance, OfNothingHasNoResidual) {
    EXPECT_EQ(EnergyBalance{}.relative_residual(), 0.0);
    // nothing is turned over: what rounding makes of the energy held is next to nothing
    EnergyBalance idle;
    idle.held = 100.0;
    idle.stored = idle.residual = 1e-14;
    EXPECT_DOUBLE_EQ(idle.relative_residual(), 1e-13);
    EXPECT_EQ(weighed({Reason::completed, 1.0}, idle, 1e-9).reason, Reason::completed);
    idle.residual = 1e-9;
    EXPECT_EQ(weighed({Reason::completed, 1.0}, idle, 1e-9).reason, Reason::unbalanced);
    EXPECT_EQ(weighed({Reason::cancelled, 1.0}, idle, 1e-9).reason, Reason::cancelled);
    idle.residual = std::numeric_limits<double>::infinity();
    EXPECT_EQ(weighed({Reason::settled, 1.0}, idle, 1e-9).reason, Reason::diverged);
}

TEST(EnergyBalance, KnowsALoadThatContactsCarryToItsRoundingOnly) {
    // nothing gives way: springs and masses hold next to nothing, and what moves is rounding
    EnergyBalance idle;
    idle.held = 1e-26;
    idle.carried = 1e-11;
    idle.stored = idle.residual = 1e-34;
    EXPECT_DOUBLE_EQ(idle.relative_residual(), 1e-20);
    EXPECT_EQ(weighed({Reason::completed, 1.0}, idle, 1e-9).reason, Reason::completed);
    idle.residual = 1e-22;
    EXPECT_EQ(weighed({Reason::completed, 1.0}, idle, 1e-9).reason, Reason::unbalanced);
}

}  // namespace
}  // namespace stridor::integration
