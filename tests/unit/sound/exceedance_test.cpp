#include "stridor/sound/exceedance.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::sound {
namespace {

TEST(Exceedance, OfEvenValuesIsTheirShare) {
    Exceedance counted;
    for (int n = 1; n <= 1000; ++n)
        counted.count(0.01 * n);
    EXPECT_EQ(counted.values(), 1000U);
    EXPECT_EQ(counted.greatest(), 10.0);
    EXPECT_NEAR(counted.exceeded(0.05), 9.5, 0.015);
    EXPECT_NEAR(counted.exceeded(0.5), 5.0, 0.015);
    EXPECT_NEAR(counted.exceeded(0.0), 10.0, 0.01);
}

TEST(Exceedance, OfNothingIsNone) {
    EXPECT_EQ(Exceedance().exceeded(0.05), 0.0);
    EXPECT_EQ(Exceedance().greatest(), 0.0);
}

TEST(Exceedance, TakesWhatIsBeyondAllNumbers) {
    Exceedance counted;
    counted.count(0.0);
    counted.count(std::numeric_limits<double>::infinity());
    counted.count(1e9);
    EXPECT_EQ(counted.values(), 3U);
    EXPECT_NEAR(counted.exceeded(0.1), 1e4, 20.0);
}

}  // namespace
}  // namespace stridor::sound
