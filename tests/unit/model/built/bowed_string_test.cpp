#include "stridor/model/built/bowed_string.hpp"

#include "stridor/model/built/built_structure.hpp"

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

TEST(BowedString, HasItsShapeAtTheBowAndNoneAtItsEnds) {
    const BowedString string;
    constexpr int modes = 40;
    const Structure structure = bowed_string(string, modes);
    EXPECT_EQ(string_shape(string, modes, string.bow_position), structure.contacts.front().tangent);
    EXPECT_EQ(string_shape(string, modes, 0.0).norm(), 0.0);
    EXPECT_LT(string_shape(string, modes, 1.0).norm(), 1e-12);
    // Helmholtz' motion of a bow that moves with 1: a point passes the rest with x/L over b, but for the modes beyond
    const Eigen::VectorXd velocity = helmholtz_motion(string, modes, 1.0);
    EXPECT_NEAR(string_shape(string, modes, 0.5).dot(velocity) * string.bow_position, 0.5,
                2.0 / (3.14159 * (modes + 1)));
}

TEST(BowedString, IsDrawnFromEndToEnd) {
    parameters::Recipe recipe;
    recipe.builder = "string";
    const parameters::OwnStructure own = built_string(recipe);
    const BowedString string;
    ASSERT_GT(own.outline.size(), 20U);
    EXPECT_EQ(own.outline.front().position[2], 0.0);
    EXPECT_EQ(own.outline.back().position[2], string.length);
    const int modes = static_cast<int>(own.row.size()) - 1;
    for (const parameters::OutlinePoint& point : own.outline) {
        const Eigen::VectorXd shape = string_shape(string, modes, point.position[2] / string.length);
        for (std::size_t row = 0; row < own.row.size(); ++row)
            EXPECT_NEAR(point.along[row], shape(static_cast<Eigen::Index>(row)), 1e-12);
    }
}

TEST(BowedString, HasSchellengsLimits) {
    const BowedString string{.bridge_resistance = 35.0, .bow_position = 0.1};
    EXPECT_NEAR(greatest_bow_force(string, 0.1), 1.4, 1e-15);
    EXPECT_NEAR(least_bow_force(string, 0.1), 0.035, 1e-15);
}

}  // namespace
}  // namespace stridor::model
