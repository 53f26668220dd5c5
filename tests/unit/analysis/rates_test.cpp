#include "stridor/analysis/rates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::analysis {
namespace {

TEST(Rates, AreSharesOfTheTotal) {
    const Rates shares = rates({1.0, 2.0, 5.0});  // slip, stick, separation
    EXPECT_EQ(shares.slip, 0.125);
    EXPECT_EQ(shares.stick, 0.25);
    EXPECT_EQ(shares.separation, 0.625);
}

TEST(Rates, OfNoTimeAreUnknown) {
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).slip));
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).stick));
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).separation));
}

}  // namespace
}  // namespace stridor::analysis
