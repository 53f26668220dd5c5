#include "stridor/pictures/parts/chart_cells.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/layout.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::pictures {
namespace {

constexpr int many = 2 * most_shown + 1;  // every third is shown

// a chart with more points in x than can be shown; the slip of a cell is its index
sweep::SweepResult wide_chart() {
    sweep::Study study = small_study();
    study.x.points = many;
    std::vector<sweep::Cell> cells(sweep::cell_count(study), quiet_cells().front());
    for (std::size_t index = 0; index < cells.size(); ++index)
        set_figure(cells[index], sweep::cell_figure("slip"), static_cast<double>(index));
    cells[3].category = classification::Category::creak;
    cells[4].category = classification::Category::squeal;
    return sweep::complete(study, std::move(cells));
}

// the same with the second of each three cells inferred from the first one
sweep::SweepResult wide_refined_chart() {
    sweep::SweepResult result = wide_chart();
    std::vector<sweep::IndexedCell> computed;
    for (std::size_t index = 0; index < result.cells.size(); ++index) {
        const bool is_taken_over = index % many % 3 == 0 && index % many > 0;
        result.sources.push_back(static_cast<sweep::CellIndex>(is_taken_over ? index - 1 : index));
        if (!sweep::is_inferred(result, index)) {
            computed.push_back({index, quiet_cells().front()});
            set_figure(computed.back().cell, sweep::cell_figure("slip"), static_cast<double>(index));
        }
    }
    result.computed = sweep::in_memory(std::move(computed));
    return result;
}

TEST(ShownCells, AreAllOfAUsualChart) {
    const sweep::SweepResult result = sweep::complete(small_study(), quiet_cells());
    const ShownCells shown(result);
    EXPECT_EQ(&shown.chart(), &result);
    EXPECT_TRUE(shown.caption().empty());
    EXPECT_EQ(shown.values(sweep::cell_figure("slip")), std::vector<double>(24, 1.0));
}

TEST(ShownCells, AreEveryThirdOfAWideOne) {
    const sweep::SweepResult result = wide_chart();
    const ShownCells shown(result);
    const sweep::Study& study = shown.chart().study;
    EXPECT_EQ(study.x.points, many / 3);
    EXPECT_EQ(study.y.points, 3);
    EXPECT_LE(study.x.points, most_shown);
    for (int ix = 0; ix < study.x.points; ++ix)
        EXPECT_NEAR(sweep::value_at(study.x, ix), sweep::value_at(result.study.x, 3 * ix),
                    1e-12 * sweep::value_at(study.x, ix));
    EXPECT_EQ(shown.chart().cells.size(), sweep::cell_count(study));
    EXPECT_EQ(shown.chart().cells[1].category, classification::Category::creak);
    EXPECT_EQ(drawing::plain_text(shown.caption().at(0)), "Of the cells every 3rd in x and each in y is drawn.");
}

TEST(ShownCells, HaveTheirOwnFigures) {
    for (const sweep::SweepResult& result : {wide_chart(), wide_refined_chart()}) {
        const ShownCells shown(result);
        const std::vector<double> whole = sweep::figure_values(result, sweep::cell_figure("slip"));
        const std::vector<double> values = shown.values(sweep::cell_figure("slip"));
        ASSERT_EQ(values.size(), sweep::cell_count(shown.chart().study));
        for (std::size_t index = 0; index < values.size(); ++index) {
            sweep::CellPlace place = sweep::place_of(shown.chart().study, index);
            place.ix *= 3;
            ASSERT_EQ(values[index], whole[sweep::index_of(result.study, place)]) << index;
        }
    }
}

TEST(ShownCells, AreThoseOfThePicture) {
    const sweep::SweepResult result = wide_chart();
    const drawing::Scene scene = noise_chart(result);
    const drawing::CategoryCells map = layers_of<drawing::CategoryCells>(scene.panels[0]).at(0);
    EXPECT_EQ(map.kinds.size(), 3U * (many / 3));
    EXPECT_EQ(map.x_edges, cell_edges(ShownCells(result).chart().study.x));
    EXPECT_EQ(drawing::plain_text(scene.caption.back()), "Of the cells every 3rd in x and each in y is drawn.");
    const drawing::Scene slip = figure_chart(result, "slip");
    EXPECT_EQ(layers_of<drawing::ValueCells>(slip.panels[1]).at(0).values.size(), 3U * (many / 3));
}

using classification::Category;

drawing::Line going_line(const sweep::SweepResult& result) {
    return boundary_line(result.study, sweep::boundaries(result), 0);
}

TEST(BoundaryLine, IsEmptyWhereNothingDiffers) {
    EXPECT_TRUE(going_line(quiet_sweep()).x.empty());
}

TEST(BoundaryLine, SurroundsAnIslandAlongTheEdgesOfItsCell) {
    sweep::SweepResult result = quiet_sweep();
    result.cells[1 * 4 + 2].category = Category::creak;
    const drawing::Line line = going_line(result);
    const std::vector<double> x = cell_edges(result.study.x);
    const std::vector<double> y = cell_edges(result.study.y);
    ASSERT_FALSE(line.x.empty());
    EXPECT_EQ(line.x.front(), line.x.back());
    EXPECT_EQ(line.y.front(), line.y.back());
    const auto [left, right] = std::minmax_element(line.x.begin(), line.x.end());
    const auto [low, high] = std::minmax_element(line.y.begin(), line.y.end());
    // a product under one root or two roots: each rounds once or thrice
    EXPECT_NEAR(*left, x[2], 1e-12 * x[2]);
    EXPECT_NEAR(*right, x[3], 1e-12 * x[3]);
    EXPECT_NEAR(*low, y[1], 1e-15);
    EXPECT_NEAR(*high, y[2], 1e-15);
}

TEST(BoundaryLine, IsUprightOrLevelEverywhere) {
    sweep::SweepResult result = quiet_sweep();
    for (const std::size_t cell : {1U, 6U, 7U, 9U, 11U})
        result.cells[cell].category = cell % 2 == 0 ? Category::squeal : Category::creak;
    const drawing::Line line = going_line(result);
    EXPECT_GT(std::count_if(line.y.begin(), line.y.end(), [](double y) { return std::isnan(y); }), 0);
    for (std::size_t k = 1; k < line.x.size(); ++k) {
        if (std::isnan(line.y[k]) || std::isnan(line.y[k - 1])) continue;
        EXPECT_TRUE(line.x[k] == line.x[k - 1] || line.y[k] == line.y[k - 1]) << k;
    }
}

TEST(BoundaryLine, ReachesTheFrame) {
    sweep::SweepResult result = quiet_sweep();
    for (const std::size_t row : {0U, 1U, 2U})
        result.cells[row * 4 + 3].category = Category::creak;
    const drawing::Line line = going_line(result);
    EXPECT_EQ(line.y.front(), cell_edges(result.study.y).front());
    EXPECT_EQ(line.y.back(), cell_edges(result.study.y).back());
}

sweep::SweepResult around(double preload, double friction) {
    sweep::SweepResult result = quiet_sweep();
    result.study.base.contact().preload = preload;
    result.study.base.contact().kinetic_friction = friction;
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
