#include "stridor/pictures/friction_law.hpp"

#include "pictures_support.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::pictures {
namespace {

// lines of the law itself, thicker than the helpers
std::vector<drawing::Line> law_lines(const drawing::Scene& scene) {
    std::vector<drawing::Line> lines = layers_of<drawing::Line>(scene.panels.at(0));
    std::erase_if(lines, [](const drawing::Line& line) { return line.stroke.width < 1.0; });
    return lines;
}

TEST(FrictionLaw, JumpsAtRestAndIsFlatElsewhere) {
    parameters::Contact contact;
    contact.static_friction = 0.8;
    contact.kinetic_friction = 0.6;
    const std::vector<drawing::Line> lines = law_lines(friction_law(contact));
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].y, (std::vector<double>{-0.6, -0.6}));
    EXPECT_EQ(lines[1].x, (std::vector<double>{0.0, 0.0}));
    EXPECT_EQ(lines[1].y, (std::vector<double>{-0.8, 0.8}));
    EXPECT_EQ(lines[2].y, (std::vector<double>{0.6, 0.6}));
}

TEST(FrictionLaw, HasTwoSidesWhereItDiffersEachWay) {
    parameters::Contact contact;
    contact.friction = parameters::FrictionKind::directional;
    contact.static_friction_coming = 0.4;
    contact.kinetic_friction_coming = 0.2;
    const drawing::Scene scene = friction_law(contact);
    const std::vector<drawing::Line> lines = law_lines(scene);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].y, (std::vector<double>{-0.2, -0.2}));  // a plate that comes
    EXPECT_EQ(lines[1].y, (std::vector<double>{-0.4, 0.8}));
    EXPECT_EQ(lines[2].y, (std::vector<double>{0.6, 0.6}));
    EXPECT_TRUE(
        std::any_of(scene.panels.at(0).y.ticks.begin(), scene.panels.at(0).y.ticks.end(),
                    [](const drawing::Tick& tick) { return drawing::plain_text(tick.label) == "−μsc = −0.4"; }));
}

TEST(FrictionLaw, NamesBothCoefficients) {
    const drawing::Scene scene = friction_law({});
    EXPECT_EQ(drawing::plain_text(scene.panels.at(0).y.label), "friction over normal force T / N");
    std::vector<std::string> labels;
    for (const drawing::Tick& tick : scene.panels.at(0).y.ticks)
        labels.push_back(drawing::plain_text(tick.label));
    for (const std::string label : {"μs = 0.8", "−μs = −0.8", "μd = 0.6", "−μd = −0.6"})
        EXPECT_EQ(std::count(labels.begin(), labels.end(), label), 1) << label;
}

TEST(FrictionLaw, OfJointsThatDifferIsRefused) {
    parameters::Case c;
    c.joints.resize(2);
    EXPECT_EQ(law_lines(friction_law_of(c)).size(), 3U);
    c.joints[1].contact.kinetic_friction = 0.3;
    EXPECT_TRUE(support::thrown_by([&] { friction_law_of(c); }).says("the joints differ: contact.kinetic_friction"));
}

TEST(FrictionLaw, OfEqualCoefficientsNamesThemOnce) {
    parameters::Contact contact;
    contact.static_friction = 0.6;
    EXPECT_EQ(friction_law(contact).panels.at(0).y.ticks.size(), 3U);
}

}  // namespace
}  // namespace stridor::pictures
