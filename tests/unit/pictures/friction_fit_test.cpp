#include "stridor/pictures/friction_fit.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/text.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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

TEST(FrictionOverConditionsScene, HasAColourForThePointsAndTheCurveOfEachTemperature) {
    const analysis::FrictionOverConditions over = analysis::friction_over_temperature(
        {{60.0, falling_friction(8.0).data}, {23.0, falling_friction(6.0).data}, {5.0, falling_friction(7.0).data}});
    const drawing::Scene scene = friction_over_conditions(over, over.whole.best);
    const auto points = layers_of<drawing::Points>(scene.panels.at(0));
    const auto curves = layers_of<drawing::Line>(scene.panels[0]);
    const auto left = layers_of<drawing::Points>(scene.panels.at(1));
    ASSERT_EQ(points.size(), 3U);
    ASSERT_EQ(curves.size(), 3U);
    ASSERT_EQ(left.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        const analysis::FittedLaw& law = analysis::law_at(over, over.whole.best, k);
        EXPECT_EQ(drawing::hex(points[k].colour), drawing::hex(curves[k].stroke.colour));
        EXPECT_EQ(left[k].y, law.residuals);
        EXPECT_NEAR(curves[k].y.back(), law.contact.kinetic_friction, 0.02);
    }
    EXPECT_NE(drawing::hex(points[0].colour), drawing::hex(points[2].colour));
    ASSERT_EQ(scene.legend.size(), 4U);
    EXPECT_EQ(drawing::plain_text(scene.legend[1].text), "at 23 degC");
}

// twelve slips of Coulomb's law, each with its own force of release, sampled at its own phase
analysis::FrictionFit fitted_slips() {
    constexpr analysis::MeasuringRig rig{0.127, 2000.0, 0.0};
    parameters::Contact shape;
    shape.static_friction = 1.0;
    shape.kinetic_friction = 0.6;
    analysis::FrictionPoints points;
    for (std::size_t slip = 0; slip < 12; ++slip) {
        analysis::RecordedSlip recorded;
        recorded.rate = 1000.0;
        recorded.velocity = 4e-3;
        recorded.normal_force = 10.0;
        recorded.limit = 5.0 + 0.01 * static_cast<double>(slip % 5);
        recorded.climb = 8.0;
        recorded.onset = 0.0104 + 1e-4 * static_cast<double>(slip % 7);
        std::vector<double> times;
        for (int k = 0; k < 34; ++k)
            times.push_back(1e-3 * k - recorded.onset);
        recorded.force =
            analysis::slip_track(model::friction_law(shape), rig, {recorded.velocity, recorded.limit, 1e-4}, times)
                .force;
        for (std::size_t k = 0; k < recorded.force.size(); ++k)
            recorded.force[k] += (k * k + slip) % 3 == 0 ? 2e-3 : -1e-3;
        points.slips.push_back(std::move(recorded));
    }
    return analysis::friction_fit(std::move(points), rig);
}

TEST(FrictionFitScene, ShowsSlipsAndTheMotionOfTheRig) {
    const analysis::FrictionFit fit = fitted_slips();
    ASSERT_EQ(fit.slips, 12U);
    const std::size_t law = law_called(fit, "coulomb");
    const drawing::Scene scene = friction_fit(fit, law);
    ASSERT_EQ(scene.panels.size(), 2U);
    const drawing::Points samples = layers_of<drawing::Points>(scene.panels[0]).at(0);
    const drawing::Points left = layers_of<drawing::Points>(scene.panels[1]).at(0);
    EXPECT_GT(samples.x.size(), 12U * 25U);
    ASSERT_EQ(left.y.size(), samples.y.size());
    const drawing::Line motion = layers_of<drawing::Line>(scene.panels[0]).at(0);
    const double w0 = std::sqrt(2000.0 / 0.127);
    for (std::size_t k = 0; k < samples.x.size(); ++k) {
        EXPECT_NEAR(samples.y[k], 1.0, 0.85);
        EXPECT_LT(std::abs(left.y[k]), 1e-3);  // 2 mN of 5 N, and what the fit leaves
    }
    // 0.6 + 0.4 cos of the swing, and the little that the drive adds; of 2.02 N, of 5.02 N
    for (std::size_t k = 0; k < motion.x.size(); ++k) {
        if (motion.x[k] < 0.0 || motion.x[k] > 20.0) continue;
        const double t = 1e-3 * motion.x[k];
        EXPECT_NEAR(motion.y[k], 0.6 + 0.4 * std::cos(w0 * t) + 2000.0 * 4e-3 / w0 / 5.02 * std::sin(w0 * t), 2e-3);
    }
    EXPECT_EQ(drawing::plain_text(scene.legend.front().text), "coulomb");
}

TEST(FrictionFitScene, NeedsPoints) {
    analysis::FrictionPoints points;
    points.kinetic_friction = {0.3, 0.01, 20};
    const analysis::FrictionFit fit = analysis::friction_fit(points);
    EXPECT_TRUE(support::thrown_by([&] { friction_fit(fit, fit.best); }).says("nothing to draw"));
}

}  // namespace
}  // namespace stridor::pictures
