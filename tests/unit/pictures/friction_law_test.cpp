#include "stridor/pictures/friction_law.hpp"

#include "pictures_support.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

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

TEST(FrictionLaw, ShowsHowItsLimitGrowsWithRest) {
    parameters::Contact contact;
    contact.rest = parameters::RestKind::logarithmic;
    contact.rest_growth = 0.02;
    contact.rest_time = 0.5;
    const drawing::Scene scene = friction_law(contact);
    const std::vector<drawing::Points> points = layers_of<drawing::Points>(scene.panels.at(0));
    ASSERT_EQ(points.size(), 2U);
    for (std::size_t k = 0; k < 3; ++k) {
        const double limit = 0.8 + 0.02 * std::log(1.0 + std::pow(10.0, static_cast<double>(k)));
        EXPECT_NEAR(points[0].y[k], limit, 1e-15);
        EXPECT_NEAR(points[1].y[k], -limit, 1e-15);
    }
    EXPECT_GT(scene.panels.at(0).y.range.to, points[0].y.back());
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

TEST(FrictionLaw, IsACurveWhereItChangesWithTheSlipVelocity) {
    parameters::Contact contact;
    contact.friction = parameters::FrictionKind::stribeck;
    contact.static_friction = 0.8;
    contact.kinetic_friction = 0.2;
    const drawing::Scene scene = friction_law(contact);
    const std::vector<drawing::Line> lines = law_lines(scene);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_GT(lines[2].x.size(), 100U);
    EXPECT_EQ(lines[2].y.front(), 0.8);
    EXPECT_NEAR(lines[2].y.back(), 0.2, 1e-4);
    EXPECT_EQ(lines[0].y.back(), -0.8);  // from fast to slow
    EXPECT_EQ(scene.panels.at(0).x.range.to, 10.0 * contact.stribeck_velocity);
    EXPECT_TRUE(scene.panels.at(0).x.ticks.empty());  // numbers along the axis
}

TEST(FrictionLaw, KnowsTheSlipOfAStructure) {
    parameters::OwnStructure own;
    own.row = {"a", "b"};
    own.contacts.resize(1);
    own.contacts.front().tangent = {1.0, -1.0};
    own.contacts.front().drive_share = 0.5;
    parameters::Case c;
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    record::Trace trace;
    trace.time = {0.0, 1.0};
    trace.velocity = {{0.1, 0.3}, {0.2, 0.1}};
    trace.surface_velocity = {1.0, 1.0};
    trace.contacts.resize(1);
    trace.contacts[0].state.assign(2, model::ContactState::slip);
    const std::optional<drawing::Extent> visited = visited_velocities(c, trace);
    ASSERT_TRUE(visited);
    EXPECT_DOUBLE_EQ(visited->from, 0.3);  // 0.5 V - (0.3 - 0.1)
    EXPECT_DOUBLE_EQ(visited->to, 0.6);    // 0.5 V - (0.1 - 0.2)
}

TEST(FrictionLaw, ShadesTheVelocitiesOfAMotion) {
    record::Trace trace;
    trace.time = {0.0, 1.0, 2.0, 3.0};
    trace.velocity = {{0.1, 0.0, -2.0, 5.0}, {9.0, 9.0, 9.0, 9.0}, {}};
    trace.surface_velocity = {0.1, 0.1, 0.1, 0.1};
    trace.contacts.resize(1);
    trace.contacts[0].state = {model::ContactState::stick, model::ContactState::slip, model::ContactState::slip,
                               model::ContactState::separation};
    const std::optional<drawing::Extent> visited = visited_velocities({}, trace);
    ASSERT_TRUE(visited);
    EXPECT_EQ(*visited, (drawing::Extent{0.1, 2.1}));
    const drawing::Scene scene = friction_law({}, visited);
    const std::vector<drawing::Boxes> boxes = layers_of<drawing::Boxes>(scene.panels.at(0));
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_EQ(boxes[0].boxes[0].x, *visited);
    EXPECT_GT(scene.panels.at(0).x.range.to, 2.1);
    trace.contacts[0].state.assign(4, model::ContactState::stick);
    EXPECT_FALSE(visited_velocities({}, trace));
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
