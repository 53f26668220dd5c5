#include "stridor/integration/energy_balance.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

TEST(EnergyBalance, ResidualIsAShareOfAllThatWentInOrOut) {
    const EnergyBalance balance{-1.0, -2.0, 4.0, 1.0, 2.0, 6.0, 0.4};
    EXPECT_DOUBLE_EQ(balance.relative_residual(), 0.4 / 16.0);
}

TEST(EnergyBalance, OfNothingHasNoResidual) {
    EXPECT_EQ(EnergyBalance{}.relative_residual(), 0.0);
}

}  // namespace
}  // namespace stridor::integration
