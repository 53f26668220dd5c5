#include "stridor/model/bowed_string.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

// a wave that comes back from the bridge has (R - Z)/(R + Z) of its amplitude, once a period
TEST(BowedString, LosesInAPeriodWhatItsBridgeTakes) {
    const BowedString string{.damping_ratio = 0.0, .bridge_resistance = 100.0 * 0.35};
    const Structure structure = bowed_string(string, 20);
    for (int k = 0; k < 20; ++k) {
        const double kept = std::exp(-0.5 * structure.damping(k, k) / string.frequency);
        EXPECT_NEAR(kept, 99.0 / 101.0, 1e-6);  // O((Z/R)^3)
    }
    const Structure stiff = bowed_string({.damping_ratio = 1e-3}, 1);
    EXPECT_EQ(stiff.damping(0, 0), 2e-3 * std::sqrt(stiff.stiffness(0, 0)));
}

TEST(BowedString, HasSchellengsLimits) {
    const BowedString string{.bridge_resistance = 35.0, .bow_position = 0.1};
    EXPECT_NEAR(greatest_bow_force(string, 0.1), 1.4, 1e-15);
    EXPECT_NEAR(least_bow_force(string, 0.1), 0.035, 1e-15);
}

}  // namespace
}  // namespace stridor::model
