#include "stridor/io/case/toml_joints.hpp"

#include "io_support.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;

constexpr const char* joint_keys =
    "axial_stiffness = 1e7\nflexural_stiffness = 1e6\naxial_damping = \"15 %\"\nflexural_damping = 1\n"
    "incidence_angle = 70\n[joint.contact]\npreload = 20\nstatic_friction = 0.8\nkinetic_friction = 0.6\n";

std::string two_joints() {
    return std::string("title = \"two\"\n[[joint]]\nname = \"upper\"\nmass = 0.1\n") + joint_keys +
           "[[joint]]\nname = \"lower\"\nmass = 0.2\n" + joint_keys +
           "[plate]\nmass = 0.4\nstiffness = 1e6\ndamping = 1\n[drive]\nkind = \"constant\"\nvelocity = -0.1\n";
}

Case read_joints(const std::string& text, std::vector<std::string> overrides = {}) {
    return read_case(TomlSource{text, "case.toml", std::move(overrides)});
}

std::string refusal_of(const std::string& text, std::vector<std::string> overrides = {}) {
    const auto error = error_of([&] { read_joints(text, std::move(overrides)); });
    if (!error) return {};
    EXPECT_EQ(error->kind(), ErrorKind::input);
    return error->what();
}

TEST(TomlJoints, AreReadInTheirOrder) {
    const Case c = read_joints(two_joints());
    ASSERT_EQ(c.joints.size(), 2U);
    EXPECT_EQ(parameters::joint_name(c, 0), "upper");
    EXPECT_EQ(parameters::joint_name(c, 1), "lower");
    EXPECT_EQ(c.joint().mass, 0.1);
    EXPECT_EQ(c.joints[1].joint.mass, 0.2);
    EXPECT_EQ(c.joints[1].contact.preload, 20.0);
    EXPECT_EQ(c.joints[1].axial_ratio, 0.15);
    EXPECT_EQ(c.drive.velocity, -0.1);
}

TEST(TomlJoints, AreWrittenAsTheyAreRead) {
    const Case c = read_joints(two_joints());
    for (const Comments comments : {Comments::full, Comments::none}) {
        const Case again = read_joints(case_toml(c, {comments, ""}));
        EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
        EXPECT_EQ(again.title, "two");
    }
}

TEST(TomlJoints, AreOverriddenByNameOrAllAtOnce) {
    const Case one = read_joints(two_joints(), {"joint.lower.contact.preload=33 N", "joint.upper.mass=0.5"});
    EXPECT_EQ(one.contact().preload, 20.0);
    EXPECT_EQ(one.joints[1].contact.preload, 33.0);
    EXPECT_EQ(one.joint().mass, 0.5);
    const Case all = read_joints(two_joints(), {"mu_d=0.5"});
    EXPECT_EQ(all.contact().kinetic_friction, 0.5);
    EXPECT_EQ(all.joints[1].contact.kinetic_friction, 0.5);
}

TEST(TomlJoints, SayWhatIsWrongOnceAndWhere) {
    const std::string text = replaced(two_joints(), "name = \"lower\"\nmass = 0.2", "name = \"upper\"\nmas = 0.2");
    const std::string why = refusal_of(replaced(text, "velocity = -0.1", "velocity = \"fast\""));
    EXPECT_NE(why.find("two joints are called \"upper\""), std::string::npos) << why;
    EXPECT_NE(why.find("unknown key joint.mas"), std::string::npos) << why;
    const std::size_t first = why.find("drive.velocity");
    ASSERT_NE(first, std::string::npos) << why;
    EXPECT_NE(refusal_of(two_joints(), {"joint.lowr.mass=1"}).find("there is no joint \"lowr\""), std::string::npos);
    EXPECT_NE(refusal_of(replaced(two_joints(), "name = \"lower\"\n", "")).find("this joint has no name"),
              std::string::npos);
    EXPECT_NE(refusal_of(two_joints() + "[contact]\npreload = 3\n").find("[contact] stands beside [[joint]]"),
              std::string::npos);
    EXPECT_NE(refusal_of(two_joints(), {"run.engine=beta_2"}).find("the beta_2 engine knows one contact"),
              std::string::npos);
    EXPECT_NE(refusal_of(two_joints(), {"contact.impact=normal-only"}).find("plastic impacts only"), std::string::npos);
}

TEST(TomlJoints, SayWhereAKeyOfTheContactBelongs) {
    const std::string why = refusal_of(replaced(two_joints(), "mass = 0.2", "mass = 0.2\npreload = \"5 N\""));
    EXPECT_NE(why.find("unknown key joint.preload"), std::string::npos) << why;
    EXPECT_NE(why.find("Write it below [joint.contact] of this joint."), std::string::npos) << why;
    EXPECT_EQ(why.find("Did you mean"), std::string::npos) << why;
}

TEST(TomlJoints, OfAListThatIsTooLongAreRefused) {
    std::string text = two_joints();
    for (std::size_t k = 0; k < parameters::most_joints; ++k)
        text += "[[joint]]\nname = \"j" + std::to_string(k) + "\"\nmass = 1\n" + joint_keys;
    EXPECT_NE(refusal_of(text).find("more than 16 joints"), std::string::npos);
}

// the joints without the friction that follows the temperature, and a table of it
std::string joints_with_table(const std::string& lists) {
    std::string text = two_joints();
    text = replaced(text, "kinetic_friction = 0.6\n[[joint]]", "[[joint]]");
    text = replaced(text, "kinetic_friction = 0.6\n[plate]", "[plate]");
    return text + "[temperature]\nvalue = -10\nat = [-30, 10, 50]\n" + lists;
}

constexpr const char* two_lists =
    "joint.upper.contact.kinetic_friction = [0.2, 0.4, 0.6]\njoint.lower.mu_d = [0.7, 0.5, 0.1]\n";

TEST(TomlJoints, FollowTheTemperatureEachByItsOwnLists) {
    const Case c = read_joints(joints_with_table(two_lists));
    EXPECT_DOUBLE_EQ(c.contact().kinetic_friction, 0.3);
    EXPECT_DOUBLE_EQ(c.joints[1].contact.kinetic_friction, 0.6);
    const Case hot = read_joints(joints_with_table(two_lists), {"temperature=50"});
    EXPECT_EQ(hot.contact().kinetic_friction, 0.6);
    EXPECT_EQ(hot.joints[1].contact.kinetic_friction, 0.1);
    const Case other = read_joints(joints_with_table(two_lists), {"temperature.joint.lower.mu_d=0.1,0.1,0.2"});
    EXPECT_EQ(other.joints[1].contact.kinetic_friction, 0.1);
    for (const Comments comments : {Comments::full, Comments::none}) {
        const Case again = read_joints(case_toml(c, {comments, ""}));
        EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
    }
}

TEST(TomlJoints, ShareAListThatNamesNone) {
    const Case c = read_joints(joints_with_table("mu_d = [0.2, 0.4, 0.6]\n"), {"temperature=-30"});
    EXPECT_EQ(c.contact().kinetic_friction, 0.2);
    EXPECT_EQ(c.joints[1].contact.kinetic_friction, 0.2);
}

TEST(TomlJoints, MayFollowTheTemperatureOneAlone) {
    std::string text = joints_with_table("joint.lower.mu_d = [0.7, 0.5, 0.1]\n");
    text =
        replaced(text, "static_friction = 0.8\n[[joint]]", "static_friction = 0.8\nkinetic_friction = 0.6\n[[joint]]");
    const Case c = read_joints(text);
    EXPECT_EQ(c.contact().kinetic_friction, 0.6);
    EXPECT_DOUBLE_EQ(c.joints[1].contact.kinetic_friction, 0.6);
    EXPECT_DOUBLE_EQ(read_joints(text, {"temperature=30"}).joints[1].contact.kinetic_friction, 0.3);
    EXPECT_EQ(parameters::canonical_text(read_joints(case_toml(c, {Comments::full, ""}))),
              parameters::canonical_text(c));
}

TEST(TomlJoints, SayWhatIsWrongInTheirTable) {
    const auto says = [](const std::string& lists, const std::string& words) {
        const std::string message = refusal_of(joints_with_table(lists));
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    says(std::string(two_lists) + "joint.uper.k1i = [1, 2, 3]\n", "there is no joint \"uper\"");
    says(std::string(two_lists) + "joint.upper.stiffness = [1, 2, 3]\n",
         "\"joint.upper.stiffness\" is no key of a joint");
    says(std::string(two_lists) + "mu_d = [1, 2, 3]\n", "contact.kinetic_friction again");
    says("joint.lower.mu_d = [0.7, 0.5, 0.1]\n", "missing key contact.kinetic_friction");
    says("joint.upper.mu_d = [0.7, 0.5]\njoint.lower.mu_d = [0.7, 0.5, 0.1]\n", "2 values over 3 temperatures");
    says("joint.upper.mu_d = [0.7, 0.5, 0.4]\njoint.lower.mu_d = [0.9, 0.9, 0.9]\n", "exceeds");
}

}  // namespace
}  // namespace stridor::io
