#include "stridor/pictures/parts/shown_cells.hpp"

#include "pictures_support.hpp"
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

}  // namespace
}  // namespace stridor::pictures
