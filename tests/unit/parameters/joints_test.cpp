#include "stridor/parameters/joints.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::parameters {
namespace {

Case two_joints() {
    Case c;
    c.joints = {{.name = "upper"}, {.name = "lower"}};
    c.joints[1].joint.mass = 0.3;
    c.joints[1].contact.preload = 55.0;
    set_from_text({c, 1}, *find_field("joint.axial_damping"), "15 %");
    return c;
}

TEST(Joints, OfAPlainCaseIsOne) {
    EXPECT_EQ(Case().joints.size(), 1U);
    EXPECT_EQ(joint_name(Case(), 0), "joint");
    Case named;
    named.joints[0].name = "lip";
    EXPECT_EQ(canonical_text(named), canonical_text(Case()));
}

TEST(Joints, AreAskedEachForItself) {
    const Case c = two_joints();
    ASSERT_EQ(c.joints.size(), 2U);
    EXPECT_EQ(joint_name(c, 0), "upper");
    EXPECT_EQ(joint_name(c, 1), "lower");
    EXPECT_EQ(get_quantity({c, 1}, *find_field("joint.mass")), 0.3);
    EXPECT_EQ(get_quantity({c, 1}, *find_field("contact.preload")), 55.0);
    EXPECT_EQ(damping_ratio({c, 1}, *find_field("joint.axial_damping")), 0.15);
    EXPECT_EQ(value_text({c, 1}, *find_field("joint.axial_damping")), "damping ratio 0.15");
    EXPECT_EQ(get_quantity(c, *find_field("joint.mass")), Joint().mass);
    EXPECT_FALSE(damping_ratio(c, *find_field("joint.axial_damping")));
}

TEST(Joints, StandInTheCanonicalTextByTheirNames) {
    const std::string text = canonical_text(two_joints());
    EXPECT_NE(text.find("joint.upper.mass = 0.1 kg\n"), std::string::npos);
    EXPECT_NE(text.find("joint.lower.mass = 0.3 kg\n"), std::string::npos);
    EXPECT_NE(text.find("joint.lower.contact.preload = 55 N\n"), std::string::npos);
    EXPECT_EQ(text.find("\njoint.mass"), std::string::npos);
    EXPECT_EQ(text.find("\ncontact."), std::string::npos);
    EXPECT_NE(text.find("\nplate.mass = 0.4 kg\n"), std::string::npos);
}

TEST(Joints, AreCalledByKeys) {
    const auto key = joint_key("joint.lower.contact.preload");
    ASSERT_TRUE(key);
    EXPECT_EQ(key->joint, "lower");
    EXPECT_EQ(key->key, "contact.preload");
    EXPECT_EQ(joint_key("joint.lower.mass")->key, "joint.mass");
    EXPECT_FALSE(joint_key("joint.mass"));
    EXPECT_FALSE(joint_key("contact.preload"));
}

TEST(Joints, HaveNamesThatAreNoKeys) {
    EXPECT_TRUE(names_a_joint("lip-2"));
    for (const char* name : {"", "mass", "contact", "name", "two lips", "a.b", "lippe\n"})
        EXPECT_FALSE(names_a_joint(name)) << name;
    EXPECT_FALSE(names_a_joint(std::string(65, 'a')));
}

TEST(Joints, AreCheckedEachAndAsSeveral) {
    Case c = two_joints();
    EXPECT_TRUE(findings(c).empty());
    c.joints[1].contact.kinetic_friction = 0.9;
    ASSERT_EQ(findings(c).size(), 1U);
    EXPECT_EQ(findings(c).front().key, "contact.kinetic_friction");
    c = two_joints();
    c.joints[1].contact.impact = ImpactKind::restitution;
    ASSERT_EQ(findings(c).size(), 1U);
    EXPECT_EQ(findings(c).front().key, "contact.impact");
    c = two_joints();
    c.run.engine = Engine::beta_2;
    EXPECT_EQ(findings(c).front().key, "run.engine");
}

// a table over the temperature: the upper joint's stiffness, the friction of both and the plate's damping follow it
Case joints_over_temperature() {
    const std::vector<double> at{-30.0, 10.0};
    const auto column = [](std::string key, std::vector<double> values,
                           TemperatureColumn::Holds holds = TemperatureColumn::Holds::quantity) {
        return TemperatureColumn{std::move(key), std::move(values), holds};
    };
    const TemperatureColumn plate = column("plate.damping", {0.1, 0.2}, TemperatureColumn::Holds::damping_ratio);
    Case c;
    c.joints = {{.name = "upper"}, {.name = "lower"}};
    set_from_text(c, *find_field("joint.flexural_damping"), "10 %");
    set_temperature_table(c, at,
                          {column("joint.lower.contact.kinetic_friction", {0.7, 0.1}), plate,
                           column("joint.upper.contact.kinetic_friction", {0.3, 0.5}),
                           column("joint.upper.flexural_stiffness", {4e4, 1e4})});
    set_quantity(c, "temperature.value", -20.0);
    return c;
}

TEST(Joints, FollowTheTemperatureEachByItsOwnTable) {
    const Case c = joints_over_temperature();
    EXPECT_EQ(c.joint().flexural_stiffness, 32.5e3);
    EXPECT_EQ(c.joint().flexural_damping, 2.0 * 0.1 * std::sqrt(32.5e3 * c.joint().mass));
    EXPECT_DOUBLE_EQ(c.contact().kinetic_friction, 0.35);
    EXPECT_DOUBLE_EQ(c.joints[1].contact.kinetic_friction, 0.55);
    EXPECT_EQ(c.joints[1].joint.flexural_stiffness, Joint().flexural_stiffness);
    EXPECT_DOUBLE_EQ(*c.plate_damping_ratio, 0.125);
    EXPECT_TRUE(findings(c).empty());
    EXPECT_EQ(range_of(c, "temperature.value").high, 10.0);
    // joint by joint, the plate behind them
    ASSERT_EQ(c.temperature.columns.size(), 4U);
    EXPECT_EQ(c.temperature.columns[0].key, "joint.upper.flexural_stiffness");
    EXPECT_EQ(c.temperature.columns[2].key, "joint.lower.contact.kinetic_friction");
    EXPECT_EQ(c.temperature.columns[2].values, (std::vector{0.7, 0.1}));
    EXPECT_EQ(c.temperature.columns[3].key, "plate.damping");
}

TEST(Joints, ThatFollowTheTemperatureAreSetByItAlone) {
    Case c = joints_over_temperature();
    EXPECT_THROW(set_quantity(c, "joint.upper.flexural_stiffness", 1.0), Error);
    EXPECT_THROW(set_quantity(c, "joint.flexural_stiffness", 1.0), Error);
    EXPECT_THROW(set_quantity(c, "joint.lower.contact.kinetic_friction", 0.2), Error);
    set_quantity(c, "joint.lower.flexural_stiffness", 2e3);
    EXPECT_EQ(c.joints[1].joint.flexural_stiffness, 2e3);
    set_quantity(c, "joint.upper.mass", 0.2);
    EXPECT_EQ(c.joint().flexural_damping, 2.0 * 0.1 * std::sqrt(32.5e3 * 0.2));
    EXPECT_EQ(c.joint().flexural_stiffness, 32.5e3);
    EXPECT_DOUBLE_EQ(c.contact().kinetic_friction, 0.35);
    EXPECT_NE(temperature_column(c, "joint.upper.flexural_stiffness"), nullptr);
    EXPECT_EQ(temperature_column(c, "joint.lower.flexural_stiffness"), nullptr);
    EXPECT_NE(temperature_column(c, "joint.flexural_stiffness"), nullptr);
}

TEST(Joints, HaveTheirTablesInTheCanonicalText) {
    const std::string text = canonical_text(joints_over_temperature());
    EXPECT_NE(text.find("temperature.joint.upper.flexural_stiffness = 40000 N/m, 10000 N/m\n"), std::string::npos);
    EXPECT_NE(text.find("temperature.joint.lower.contact.kinetic_friction = 0.7, 0.1\n"), std::string::npos);
    EXPECT_NE(text.find("temperature.plate.damping = damping ratio 0.1, damping ratio 0.2\n"), std::string::npos);
    EXPECT_EQ(text.find("joint.upper.flexural_stiffness = 32500"), std::string::npos);
    EXPECT_NE(text.find("joint.lower.flexural_stiffness = "), std::string::npos);
}

}  // namespace
}  // namespace stridor::parameters
