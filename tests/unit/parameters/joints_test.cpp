#include "stridor/parameters/joints.hpp"

#include "stridor/parameters/check.hpp"
#include "stridor/parameters/field.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::parameters {
namespace {

Case two_joints() {
    Case c;
    c.joint_name = "upper";
    Case other;
    other.joint.mass = 0.3;
    other.contact.preload = 55.0;
    set_from_text(other, *find_field("joint.axial_damping"), "15 %");
    add_joint(c, "lower", other);
    return c;
}

TEST(Joints, OfAPlainCaseIsOne) {
    EXPECT_EQ(joint_count(Case()), 1U);
    EXPECT_EQ(joint_name(Case(), 0), "joint");
    EXPECT_EQ(canonical_text(alone(Case(), 0)), canonical_text(Case()));
}

TEST(Joints, AreSeenEachAlone) {
    const Case c = two_joints();
    ASSERT_EQ(joint_count(c), 2U);
    EXPECT_EQ(joint_name(c, 0), "upper");
    EXPECT_EQ(joint_name(c, 1), "lower");
    const Case lower = alone(c, 1);
    EXPECT_EQ(joint_count(lower), 1U);
    EXPECT_EQ(lower.joint.mass, 0.3);
    EXPECT_EQ(lower.contact.preload, 55.0);
    EXPECT_EQ(lower.damping_ratios.axial, 0.15);
    EXPECT_EQ(alone(c, 0).joint.mass, Case().joint.mass);
    EXPECT_FALSE(alone(c, 0).damping_ratios.axial);
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
    c.further_joints[0].contact.kinetic_friction = 0.9;
    ASSERT_EQ(findings(c).size(), 1U);
    EXPECT_EQ(findings(c).front().key, "contact.kinetic_friction");
    c = two_joints();
    c.further_joints[0].contact.impact = ImpactKind::restitution;
    ASSERT_EQ(findings(c).size(), 1U);
    EXPECT_EQ(findings(c).front().key, "contact.impact");
    c = two_joints();
    c.run.engine = Engine::beta_2;
    EXPECT_EQ(findings(c).front().key, "run.engine");
}

}  // namespace
}  // namespace stridor::parameters
