#include "stridor/parameters/fields/case_key.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stridor::parameters {
namespace {

std::string what(void (*call)()) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(CaseKey, OfOneOfSeveralJointsIsAboutTheFieldOfAJoint) {
    EXPECT_EQ(field_of("joint.lower.contact.preload"), find_field("contact.preload"));
    EXPECT_EQ(field_of("joint.lower.mass"), find_field("joint.mass"));
    EXPECT_EQ(field_of("plate.mass"), find_field("plate.mass"));
    EXPECT_EQ(field_of("joint.lower.plate"), nullptr);
    EXPECT_EQ(field_of("joint.lower"), nullptr);
    EXPECT_EQ(unit_of("joint.lower.contact.preload"), "N");
}

TEST(CaseKey, IsCalledByItsLastPartOrSymbolBelowAJoint) {
    EXPECT_EQ(key_called("joint.lower.F"), "joint.lower.contact.preload");
    EXPECT_EQ(key_called("joint.lower.preload"), "joint.lower.contact.preload");
    EXPECT_EQ(key_called("joint.lower.mass"), "joint.lower.mass");
    EXPECT_EQ(key_called("F"), "contact.preload");
    EXPECT_EQ(quantity_key_called("joint.lower.alpha"), "joint.lower.incidence_angle");
    EXPECT_NE(what([] { key_called("joint.lower.mas"); }).find("Did you mean joint.lower.mass?"), std::string::npos);
    EXPECT_NE(what([] { key_called("joint.lower.stiffness"); }).find("no key of a joint"), std::string::npos);
    EXPECT_NE(what([] { quantity_key_called("joint.lower.impact"); }).find("no quantity"), std::string::npos);
}

TEST(CaseKey, NamesAJointThatIsThere) {
    EXPECT_NO_THROW(expect_joint_of(two_lips(), "joint.lower.mass"));
    EXPECT_NE(what([] { expect_joint_of(two_lips(), "joint.lowr.mass"); }).find("Did you mean joint.lower?"),
              std::string::npos);
    EXPECT_NE(what([] { expect_joint_of(two_lips(), "joint.third.mass"); }).find("upper, lower"), std::string::npos);
    EXPECT_NE(what([] { expect_joint_of(Case(), "joint.third.contact.preload"); }).find("Write contact.preload."),
              std::string::npos);
}

TEST(CaseKey, OfOneJointSetsThatJointAlone) {
    Case c = two_lips();
    set_quantity(c, "joint.lower.contact.preload", 55.0);
    set_quantity(c, "joint.upper.mass", 0.3);
    EXPECT_EQ(c.joints[1].contact.preload, 55.0);
    EXPECT_EQ(c.contact().preload, 200.0);
    EXPECT_EQ(c.joint().mass, 0.3);
    EXPECT_EQ(c.joints[1].joint.mass, 0.1);
    EXPECT_EQ(get_quantity(c, "joint.lower.contact.preload"), 55.0);
    EXPECT_EQ(get_quantity(c, "joint.upper.contact.preload"), 200.0);
    EXPECT_EQ(value_text(c, "joint.lower.contact.preload"), "55 N");
    EXPECT_EQ(c.joints[0].name, "upper");
}

TEST(CaseKey, WithoutAJointsNameIsThatOfAll) {
    Case c = two_lips();
    EXPECT_TRUE(has_one_value(c, "contact.preload"));
    EXPECT_FALSE(has_one_value(c, "joint.incidence_angle"));
    EXPECT_EQ(value_text(c, "joint.incidence_angle"), "70 deg, 60 deg");
    set_quantity(c, "joint.incidence_angle", 80.0);
    EXPECT_EQ(c.joint().incidence_angle, 80.0);
    EXPECT_EQ(c.joints[1].joint.incidence_angle, 80.0);
    EXPECT_TRUE(has_one_value(c, "joint.incidence_angle"));
    EXPECT_EQ(single_keys(c, "contact.preload"),
              (std::vector<std::string>{"joint.upper.contact.preload", "joint.lower.contact.preload"}));
    EXPECT_EQ(single_keys(c, "plate.mass"), std::vector<std::string>{"plate.mass"});
    EXPECT_EQ(single_keys(Case(), "contact.preload"), std::vector<std::string>{"contact.preload"});
    EXPECT_TRUE(overlap(c, "contact.preload", "joint.lower.contact.preload"));
    EXPECT_FALSE(overlap(c, "joint.upper.contact.preload", "joint.lower.contact.preload"));
}

TEST(CaseKey, KeepsADampingThatIsAShareOfItsOwnJoints) {
    Case c = two_lips();
    Case of_lower;
    of_lower.joints = {c.joints[1]};
    set_from_text(of_lower, *find_field("joint.axial_damping"), "15 %");
    set_from_text({c, 1}, *find_field("joint.axial_damping"), "15 %");
    set_quantity(c, "joint.lower.mass", 0.4);
    set_quantity(of_lower, "joint.mass", 0.4);
    EXPECT_EQ(c.joints[1].joint.axial_damping, of_lower.joint().axial_damping);
    EXPECT_EQ(c.joint().axial_damping, 1.0);
}

TEST(CaseKey, RefusesAValueInItsOwnName) {
    EXPECT_NE(what([] {
                  Case c = two_lips();
                  set_quantity(c, "joint.lower.contact.preload", -1.0);
              }).find("joint.lower.contact.preload = -1 is out of range"),
              std::string::npos);
}

TEST(CaseKey, OfEachJointAreTheQuantitiesOfSeveral) {
    const std::vector<std::string> keys = quantity_keys(two_lips());
    const auto has = [&](const char* key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
    EXPECT_TRUE(has("joint.upper.mass"));
    EXPECT_TRUE(has("joint.lower.contact.kinetic_friction"));
    EXPECT_TRUE(has("plate.mass"));
    EXPECT_FALSE(has("joint.mass"));
    EXPECT_FALSE(has("joint.lower.contact.restitution"));  // impacts are plastic
    const std::vector<std::string> plain = quantity_keys(Case());
    EXPECT_NE(std::find(plain.begin(), plain.end(), "joint.mass"), plain.end());
}

}  // namespace
}  // namespace stridor::parameters
