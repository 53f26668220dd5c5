#include "stridor/pictures/noise_chart.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace stridor::pictures {
namespace {

using classification::Category;

std::vector<std::string> legend_of(const drawing::Scene& scene) {
    std::vector<std::string> texts;
    for (const drawing::LegendEntry& entry : scene.legend)
        texts.push_back(drawing::plain_text(entry.text));
    return texts;
}

const drawing::Fill& fill_of(const drawing::CategoryCells& cells, std::size_t index) {
    return cells.fills.at(cells.kinds.at(index));
}

TEST(NoiseChart, HasAPanelPerDirectionWithTheSameAxes) {
    const drawing::Scene scene = noise_chart(quiet_sweep());
    ASSERT_EQ(scene.panels.size(), 2U);
    EXPECT_NE(drawing::plain_text(scene.panels[0].title).find("going"), std::string::npos);
    EXPECT_NE(drawing::plain_text(scene.panels[1].title).find("coming"), std::string::npos);
    for (const drawing::Panel& panel : scene.panels) {
        EXPECT_EQ(drawing::plain_text(panel.x.label), "preload F");
        EXPECT_EQ(panel.x.scale, drawing::AxisScale::logarithmic);
        EXPECT_EQ(panel.y.unit, "1");
        const std::vector<drawing::CategoryCells> maps = layers_of<drawing::CategoryCells>(panel);
        ASSERT_EQ(maps.size(), 1U);
        EXPECT_EQ(maps[0].x_edges, cell_edges(quiet_sweep().study.x));
        EXPECT_EQ(panel.x.range, (drawing::Extent{maps[0].x_edges.front(), maps[0].x_edges.back()}));
    }
}

TEST(NoiseChart, CellsStandWhereTheirIndexSays) {
    sweep::SweepResult result = quiet_sweep();
    // coming, third row, second column: (1 * 3 + 2) * 4 + 1
    result.cells[21].category = Category::squeal;
    const drawing::Scene scene = noise_chart(result);
    const drawing::CategoryCells coming = layers_of<drawing::CategoryCells>(scene.panels[1]).at(0);
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_EQ(fill_of(coming, i), category_fill(i == 2 * 4 + 1 ? Category::squeal : Category::none)) << i;
}

TEST(NoiseChart, EveryCategoryHasItsFill) {
    sweep::SweepResult result = quiet_sweep();
    constexpr std::array all{Category::none, Category::squeal, Category::squeak, Category::creak, Category::undecided};
    for (std::size_t i = 0; i < all.size(); ++i)
        result.cells[i].category = all[i];
    const drawing::Scene scene = noise_chart(result);
    const drawing::CategoryCells going = layers_of<drawing::CategoryCells>(scene.panels[0]).at(0);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(fill_of(going, i), category_fill(all[i])) << i;
    EXPECT_EQ(legend_of(scene), (std::vector<std::string>{"none", "squeak", "squeal", "creak", "undecided"}));
}

TEST(NoiseChart, FailedCellsAreCrossedAndNeverACategory) {
    for (const sweep::Status status :
         {sweep::Status::invalid, sweep::Status::step_limit, sweep::Status::diverged, sweep::Status::failed}) {
        sweep::SweepResult result = quiet_sweep();
        result.cells[3].status = status;
        for (const Category category : {Category::none, Category::squeal, Category::undecided}) {
            result.cells[3].category = category;
            const drawing::Scene scene = noise_chart(result);
            const drawing::Fill fill = fill_of(layers_of<drawing::CategoryCells>(scene.panels[0]).at(0), 3);
            EXPECT_EQ(fill, failed_fill());
            EXPECT_EQ(fill.texture, drawing::Texture::crossed);
        }
    }
}

TEST(NoiseChart, LegendTellsHowCellsFailed) {
    sweep::SweepResult result = quiet_sweep();
    EXPECT_EQ(legend_of(noise_chart(result)), (std::vector<std::string>{"none", "squeak", "squeal", "creak"}));
    result.cells[0].status = sweep::Status::failed;
    EXPECT_EQ(legend_of(noise_chart(result)).back(), "failed");
    result.cells[1].status = sweep::Status::step_limit;
    result.cells[2].status = sweep::Status::invalid;
    EXPECT_EQ(legend_of(noise_chart(result)).back(), "failed (invalid, step limit, failed)");
}

TEST(NoiseChart, LargeRegionsCarryTheirName) {
    const drawing::Layout layout = drawing::arrange(noise_chart(quiet_sweep()));
    ASSERT_EQ(layout.panels[0].notes.size(), 1U);
    EXPECT_EQ(drawing::plain_text(layout.panels[0].notes[0].text.text), "none");
}

TEST(NoiseChart, LinesPartWhatDiffers) {
    sweep::SweepResult result = quiet_sweep();
    EXPECT_TRUE(layers_of<drawing::Line>(noise_chart(result).panels[0]).empty());
    // an island and a corner, going
    result.cells[1 * 4 + 1].category = Category::creak;
    result.cells[2 * 4 + 3].category = Category::squeal;
    const drawing::Scene scene = noise_chart(result);
    const std::vector<drawing::Line> lines = layers_of<drawing::Line>(scene.panels[0]);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(layers_of<drawing::Line>(scene.panels[1]).empty());
}

TEST(NoiseChart, NamesTheStarts) {
    sweep::SweepResult result = quiet_sweep();
    result.study.starts = {parameters::Initial::rest, parameters::Initial::stuck, parameters::Initial::sliding};
    const drawing::Scene scene = noise_chart(result);
    EXPECT_EQ(drawing::plain_text(scene.caption[0]).find("initial"), std::string::npos);
    EXPECT_EQ(drawing::plain_text(scene.caption[1]),
              "Each cell was run from rest, stuck and sliding; the worst is shown.");
}

TEST(NoiseChart, MarksCellsThatAreQuietUnlessDisturbed) {
    sweep::SweepResult result = quiet_sweep();
    EXPECT_TRUE(layers_of<drawing::Points>(noise_chart(result).panels[0]).empty());
    result.cells[2 * 4 + 1].agreement = sweep::Agreement::quiet_unless_disturbed;
    result.cells[0].agreement = sweep::Agreement::differ;
    const drawing::Scene scene = noise_chart(result);
    const std::vector<drawing::Points> marks = layers_of<drawing::Points>(scene.panels[0]);
    ASSERT_EQ(marks.size(), 1U);
    EXPECT_EQ(marks[0].x, std::vector{sweep::value_at(result.study.x, 1)});
    EXPECT_EQ(marks[0].y, std::vector{sweep::value_at(result.study.y, 2)});
    EXPECT_TRUE(marks[0].rim.has_value()) << "it is seen on any category's ground";
    EXPECT_EQ(legend_of(scene).back(), "quiet unless disturbed");
}

TEST(NoiseChart, SaysHowManyCellsWereComputed) {
    sweep::SweepResult result = quiet_sweep();
    EXPECT_EQ(noise_chart(result).caption.size(), 1U);
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        result.sources.push_back(static_cast<sweep::CellIndex>(index < 9 ? 0 : index));
    const drawing::Scene scene = noise_chart(result);
    ASSERT_EQ(scene.caption.size(), 2U);
    EXPECT_EQ(drawing::plain_text(scene.caption[1]),
              "66.7 % of the cells were computed; the others lie among such that agree.");
}

TEST(FigureChart, GivesInferredCellsTheValueOfTheComputedOneTheyTakeAfter) {
    std::vector<sweep::Cell> cells = quiet_cells();
    std::vector<sweep::CellIndex> sources;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        set_figure(cells[index], sweep::cell_figure("frequency"), 400.0 + static_cast<double>(index));
        sources.push_back(static_cast<sweep::CellIndex>(index));
    }
    sources[14] = 16;
    sweep::SweepResult result = sweep::complete(small_study(), cells);
    result.sources = sources;
    const drawing::Scene scene = figure_chart(result, "frequency");
    EXPECT_EQ(layers_of<drawing::ValueCells>(scene.panels[1]).at(0).values[2], 416.0);
    EXPECT_NE(drawing::plain_text(scene.caption.back()).find("nearest corner"), std::string::npos);
}

TEST(NoiseChart, OfOneDirectionIsOnePanel) {
    sweep::SweepResult result = quiet_sweep();
    result.study.directions = {parameters::Direction::coming};
    result.cells.resize(sweep::cell_count(result.study));
    EXPECT_EQ(noise_chart(result).panels.size(), 1U);
}

TEST(FigureChart, ColoursValuesAndMarksWhatHasNone) {
    std::vector<sweep::Cell> quiet = quiet_cells();
    for (std::size_t i = 0; i < quiet.size(); ++i)
        set_figure(quiet[i], sweep::cell_figure("frequency"), 400.0 + static_cast<double>(i));
    set_figure(quiet[1], sweep::cell_figure("frequency"), sweep::Cell::unknown);
    quiet[2].status = sweep::Status::diverged;
    const drawing::Scene scene = figure_chart(sweep::complete(small_study(), quiet), "frequency");
    ASSERT_TRUE(scene.colour_bar.has_value());
    EXPECT_EQ(scene.colour_bar->unit, "Hz");
    const drawing::ValueCells cells = layers_of<drawing::ValueCells>(scene.panels[0]).at(0);
    EXPECT_EQ(cells.values[0], 400.0);
    EXPECT_TRUE(std::isnan(cells.values[1]));
    EXPECT_TRUE(std::isnan(cells.values[2])) << "a figure left behind by a failed run is not shown";
    const std::vector<drawing::Boxes> failed = layers_of<drawing::Boxes>(scene.panels[0]);
    ASSERT_EQ(failed.size(), 1U);
    EXPECT_EQ(failed[0].fill, failed_fill());
    ASSERT_EQ(failed[0].boxes.size(), 1U);
    EXPECT_EQ(failed[0].boxes[0].x, (drawing::Extent{cells.x_edges[2], cells.x_edges[3]}));
    EXPECT_EQ(legend_of(scene), (std::vector<std::string>{"no value", "failed (diverged)"}));
}

TEST(FigureChart, SharesAreDrawnFromZeroToOne) {
    EXPECT_EQ(figure_chart(quiet_sweep(), "slip").colour_bar->colours.range, (drawing::Extent{0.0, 1.0}));
}

TEST(FigureChart, ALevelOfRestDoesNotTakeAllColours) {
    std::vector<sweep::Cell> quiet = quiet_cells();
    for (sweep::Cell& cell : quiet)
        set_figure(cell, sweep::cell_figure("joint_level"), 150.0);
    set_figure(quiet[0], sweep::cell_figure("joint_level"), -200.0);
    set_figure(quiet[1], sweep::cell_figure("joint_level"), -std::numeric_limits<double>::infinity());
    const drawing::Scene scene = figure_chart(sweep::complete(small_study(), quiet), "joint_level");
    EXPECT_EQ(drawing::plain_text(scene.caption.at(1)),
              "A velocity level of the joint: a vibration, not a sound pressure.");
    EXPECT_EQ(scene.colour_bar->colours.range, (drawing::Extent{50.0, 150.0}));
    EXPECT_TRUE(std::isnan(layers_of<drawing::ValueCells>(scene.panels[0]).at(0).values[1]));
}

TEST(FigureChart, ThatDoesNotExistIsAnError) {
    const support::Thrown thrown = support::thrown_by([] { figure_chart(quiet_sweep(), "frequenzy"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("Did you mean \"frequency\"?")) << thrown.message;
}

TEST(QuantityChart, DrawsCategoriesOrFigures) {
    EXPECT_FALSE(quantity_chart(quiet_sweep(), "category").colour_bar.has_value());
    EXPECT_TRUE(quantity_chart(quiet_sweep(), "stick").colour_bar.has_value());
}

sweep::SweepResult at_angle(double angle) {
    sweep::SweepResult result = quiet_sweep();
    result.study.base.joint().incidence_angle = angle;
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
