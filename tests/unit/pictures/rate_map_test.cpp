#include "stridor/pictures/rate_map.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::pictures {
namespace {

sweep::SweepResult at_angle(double angle) {
    sweep::SweepResult result = quiet_sweep();
    result.study.base.joint.incidence_angle = angle;
    result.study.directions = {parameters::Direction::going};
    result.cells.resize(sweep::cell_count(result.study));
    return result;
}

TEST(RateMap, HasARowOfThreeMapsPerSweep) {
    const std::vector<sweep::SweepResult> results{at_angle(70.0), at_angle(150.0)};
    const drawing::Scene scene = rate_map(results);
    ASSERT_EQ(scene.panels.size(), 6U);
    EXPECT_EQ(drawing::plain_text(scene.panels[0].title), "a) α = 70°, going: slip");
    EXPECT_EQ(drawing::plain_text(scene.panels[3].title), "b) α = 150°, going: slip");
    EXPECT_EQ(drawing::plain_text(scene.panels[5].title), "separation");
    EXPECT_EQ(scene.panels[5].row, 1U);
    EXPECT_EQ(scene.panels[5].column, 2U);
    // one axis below serves both rows
    EXPECT_EQ(scene.panels[0].x.text, drawing::AxisText::hidden);
    EXPECT_EQ(scene.panels[3].x.text, drawing::AxisText::shown);
}

TEST(RateMap, CountsInPercent) {
    const std::vector<sweep::SweepResult> results{at_angle(70.0)};
    const drawing::Scene scene = rate_map(results);
    EXPECT_EQ(scene.colour_bar->colours.range, (drawing::Extent{0.0, 100.0}));
    EXPECT_EQ(scene.colour_bar->unit, "%");
    EXPECT_EQ(layers_of<drawing::ValueCells>(scene.panels[0]).at(0).values[0], 100.0);
    EXPECT_EQ(layers_of<drawing::ValueCells>(scene.panels[1]).at(0).values[0], 0.0);
}

TEST(RateMap, FailedCellsAreCrossed) {
    std::vector<sweep::SweepResult> results{at_angle(70.0)};
    results[0].cells[5].status = sweep::Status::diverged;
    const drawing::Scene scene = rate_map(results);
    const drawing::ValueCells cells = layers_of<drawing::ValueCells>(scene.panels[0]).at(0);
    EXPECT_TRUE(std::isnan(cells.values[5]));
    EXPECT_EQ(cells.missing, failed_fill());
    ASSERT_EQ(scene.legend.size(), 1U);
    EXPECT_EQ(drawing::plain_text(scene.legend[0].text), "failed");
}

TEST(RateMap, OfNothingIsAnEmptyScene) {
    EXPECT_TRUE(rate_map({}).panels.empty());
}

}  // namespace
}  // namespace stridor::pictures
