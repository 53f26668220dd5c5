#include "stridor/pictures/friction_fit.hpp"

#include "pictures_support.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::pictures {
namespace {

// friction that falls with the speed from 10 mm/s to 60 mm/s, or to a hundred times the slowest
analysis::FrictionFit falling_friction(double ratio) {
    analysis::FrictionPoints points;
    for (std::size_t k = 0; k < 60; ++k) {
        analysis::FrictionPoint point;
        const double speed = 0.01 * std::pow(ratio, static_cast<double>(k % 6) / 5.0);
        point.speeds.fill(speed);
        point.friction = 0.3 + 0.2 * std::exp(-speed / 0.02) + (k * k / 6 % 2 == 0 ? 1e-3 : -1e-3);
        points.points.push_back(point);
    }
    return analysis::friction_fit(points);
}

TEST(FrictionFitScene, ShowsPointsTheLawAndWhatItLeaves) {
    const analysis::FrictionFit fit = falling_friction(6.0);
    const std::size_t law = law_called(fit, "linear");
    ASSERT_NE(law, fit.best);
    const drawing::Scene scene = friction_fit(fit, law);
    ASSERT_EQ(scene.panels.size(), 2U);
    const auto points = layers_of<drawing::Points>(scene.panels[0]);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].x.size(), 60U);
    EXPECT_EQ(points[0].y[7], fit.data.points[7].friction);
    EXPECT_EQ(layers_of<drawing::Points>(scene.panels[1]).at(0).y, fit.laws[law].residuals);
    // the law that was asked for, and dashed those that the data bear or do not tell from it
    const auto curves = layers_of<drawing::Line>(scene.panels[0]);
    ASSERT_GE(curves.size(), 2U);
    EXPECT_EQ(curves[0].stroke.dash, drawing::Dash::solid);
    EXPECT_NEAR(curves[0].y[0], fit.laws[law].contact.kinetic_friction, 1e-12);
    EXPECT_EQ(curves[1].stroke.dash, drawing::Dash::dashed);
    EXPECT_EQ(scene.panels[0].x.scale, drawing::AxisScale::linear);
}

TEST(FrictionFitScene, HasALogarithmicAxisOverManySpeeds) {
    const analysis::FrictionFit fit = falling_friction(100.0);
    const drawing::Scene scene = friction_fit(fit, fit.best);
    EXPECT_EQ(scene.panels[1].x.scale, drawing::AxisScale::logarithmic);
    for (const drawing::Panel& panel : scene.panels) {
        EXPECT_LT(panel.x.range.from, 0.01);
        EXPECT_GT(panel.x.range.to, 1.0);
    }
}

TEST(FrictionFitScene, NeedsPoints) {
    analysis::FrictionPoints points;
    points.kinetic_friction = {0.3, 0.01, 20};
    const analysis::FrictionFit fit = analysis::friction_fit(points);
    EXPECT_TRUE(support::thrown_by([&] { friction_fit(fit, fit.best); }).says("nothing to draw"));
}

}  // namespace
}  // namespace stridor::pictures
