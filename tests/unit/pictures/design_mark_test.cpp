#include "stridor/pictures/parts/design_mark.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/layout.hpp"
#include "stridor/pictures/noise_chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::pictures {
namespace {

sweep::SweepResult around(double preload, double friction) {
    sweep::SweepResult result = quiet_sweep();
    result.study.base.contact.preload = preload;
    result.study.base.contact.kinetic_friction = friction;
    return result;
}

double middle(const sweep::Axis& axis) {
    return 0.5 * (axis.from + axis.to);
}

TEST(DesignMark, StandsAtTheCasesOwnValuesInEveryPanel) {
    const sweep::Study study = quiet_sweep().study;
    ASSERT_EQ(study.x.parameter, "contact.preload");
    ASSERT_EQ(study.y.parameter, "contact.kinetic_friction");
    const sweep::SweepResult result = around(middle(study.x), middle(study.y));
    drawing::Scene scene = noise_chart(result);
    mark_design(scene, result.study);
    for (const drawing::Panel& panel : scene.panels) {
        const drawing::Points points = layers_of<drawing::Points>(panel).back();
        EXPECT_EQ(points.x, std::vector{middle(study.x)});
        EXPECT_EQ(points.y, std::vector{middle(study.y)});
    }
    EXPECT_NE(drawing::plain_text(scene.legend.back().text).find("design: F = "), std::string::npos);
}

TEST(DesignMark, StandsOnNoName) {
    const sweep::Study study = quiet_sweep().study;
    // where the name of the only region would stand
    const drawing::Layout bare = drawing::arrange(noise_chart(quiet_sweep()));
    const drawing::PlacedPanel& panel = bare.panels[0];
    const drawing::PlacedText& name = panel.notes.at(0).text;
    const double x = (name.x - panel.area.left) / drawing::width_of(panel.area);
    const double y = (name.y - panel.area.bottom) / drawing::height_of(panel.area);
    const drawing::Panel axes = noise_chart(quiet_sweep()).panels[0];
    const sweep::SweepResult result =
        around(drawing::value_at_position(axes.x, x), drawing::value_at_position(axes.y, y));
    drawing::Scene scene = noise_chart(result);
    mark_design(scene, result.study);
    const drawing::PlacedNote moved = drawing::arrange(scene).panels[0].notes.at(0);
    EXPECT_EQ(moved.text.text, name.text);
    EXPECT_GT(std::hypot(moved.text.x - name.x, moved.text.y - name.y), 2.0) << "[mm]";
}

TEST(DesignMark, OutsideOfTheAxesTheCaptionSaysSo) {
    const sweep::Study study = quiet_sweep().study;
    const sweep::SweepResult result = around(2.0 * study.x.to, middle(study.y));
    drawing::Scene scene = noise_chart(result);
    const std::size_t entries = scene.legend.size();
    mark_design(scene, result.study);
    EXPECT_EQ(scene.legend.size(), entries);
    EXPECT_TRUE(layers_of<drawing::Points>(scene.panels[0]).empty());
    EXPECT_NE(drawing::plain_text(scene.caption.back()).find("outside"), std::string::npos);
}

TEST(DesignMark, TheDirectionGivesTheSignOfAConstantVelocity) {
    sweep::Study study = quiet_sweep().study;
    study.base.drive.kind = parameters::DriveKind::constant;
    study.base.drive.velocity = -0.1;
    study.x = {"drive.velocity", 0.01, 1.0, 3, sweep::Scale::logarithmic};
    EXPECT_EQ(sweep::own_value(study, study.x), 0.1);
}

}  // namespace
}  // namespace stridor::pictures
