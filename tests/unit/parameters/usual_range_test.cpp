#include "stridor/parameters/fields/usual_range.hpp"

#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::parameters {
namespace {

const Case paper = paper_case(PaperCase::squeal);

Case with(std::string_view key, double value) {
    Case c = paper;
    set_quantity(c, key, value);
    return c;
}

// a seal's lip is a thousand times softer than Table 1, and is varied as far
TEST(UsualRange, GoesFromATenthToTenTimesTheCasesValue) {
    for (const char* key : {"joint.mass", "joint.flexural_stiffness", "joint.axial_damping", "contact.preload"})
        for (const double value : {1e-3, 1.5, 111.0}) {
            const auto range = usual_range(with(key, value), key);
            ASSERT_TRUE(range) << key;
            EXPECT_DOUBLE_EQ(range->from, 0.1 * value) << key;
            EXPECT_DOUBLE_EQ(range->to, 10.0 * value) << key;
            EXPECT_EQ(range->scale, Scale::logarithmic) << key;
        }
}

TEST(UsualRange, OfFrictionAndAnglesIsTheFieldsOwn) {
    EXPECT_EQ(usual_range(paper, "contact.kinetic_friction")->from, 0.0);
    EXPECT_EQ(usual_range(paper, "contact.kinetic_friction")->to, 1.0);
    EXPECT_EQ(usual_range(paper, "joint.incidence_angle")->from, 20.0);
    EXPECT_EQ(usual_range(with("joint.incidence_angle", 5.0), "joint.incidence_angle")->from, 5.0);
    EXPECT_EQ(usual_range(with("contact.static_friction", 2.0), "contact.static_friction")->to, 2.0);
}

TEST(UsualRange, OfAVelocityKeepsItsSign) {
    Case c = paper;
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = -0.05;
    const auto range = usual_range(c, "drive.velocity");
    EXPECT_DOUBLE_EQ(range->from, -0.5);
    EXPECT_DOUBLE_EQ(range->to, -0.005);
}

TEST(UsualRange, OfZeroEndsWhereTheFieldSays) {
    const auto range = usual_range(with("plate.damping", 0.0), "plate.damping");
    EXPECT_EQ(range->from, 0.0);
    EXPECT_EQ(range->to, 300.0);
    EXPECT_EQ(range->scale, Scale::linear);
}

TEST(UsualRange, IsNoneOfSettingsAndOfWhatMeansNothing) {
    EXPECT_FALSE(usual_range(paper, "run.duration"));
    EXPECT_FALSE(usual_range(paper, "verdict.quiet_slip"));
    EXPECT_FALSE(usual_range(paper, "drive.velocity")) << "its drive is sinusoidal";
    EXPECT_FALSE(usual_range(paper, "no.key"));
}

TEST(UsualRange, OfTheTemperatureIsItsTable) {
    Case c = paper;
    set_temperature_table(c, {-30.0, 80.0}, {{"contact.kinetic_friction", {0.7, 0.3}}});
    keep_temperature_table(c);
    EXPECT_EQ(usual_range(c, "temperature.value")->from, -30.0);
    EXPECT_EQ(usual_range(c, "temperature.value")->to, 80.0);
    EXPECT_FALSE(usual_range(c, "contact.kinetic_friction")) << "it follows";
}

TEST(DesignKeys, HaveARangeThatHoldsTheCase) {
    for (const Case& c : {paper, two_lips()})
        for (const std::string& key : design_keys(c)) {
            const auto range = usual_range(c, key);
            ASSERT_TRUE(range) << key;
            EXPECT_LE(range->from, get_quantity(c, key)) << key;
            EXPECT_GE(range->to, get_quantity(c, key)) << key;
            EXPECT_LT(range->from, range->to) << key;
        }
    const std::vector<std::string> keys = design_keys(two_lips());
    EXPECT_NE(std::find(keys.begin(), keys.end(), "joint.lower.contact.preload"), keys.end());
}

}  // namespace
}  // namespace stridor::parameters
