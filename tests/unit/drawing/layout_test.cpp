#include "stridor/drawing/layout.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::drawing {
namespace {

// rows x columns of panels with a title, axis titles and ranges of very different numbers
Scene grid(std::size_t rows, std::size_t columns) {
    Scene scene;
    scene.title = "title";
    scene.row_heights.assign(rows, 1.0);
    scene.column_widths.assign(columns, 1.0);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            Panel panel;
            panel.row = row;
            panel.column = column;
            panel.title = "panel";
            panel.x.label = "time";
            panel.y.label = "value";
            panel.y.range = {0.0, row % 2 == 0 ? 1.0 : 9000.0};
            scene.panels.push_back(panel);
        }
    return scene;
}

TEST(Layout, PanelsOfAColumnShareTheirEnds) {
    const Scene scene = grid(3, 2);
    const Layout layout = arrange(scene);
    for (std::size_t i = 0; i < scene.panels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Rectangle& a = layout.panels[i].area;
            const Rectangle& b = layout.panels[j].area;
            if (scene.panels[i].column == scene.panels[j].column) {
                EXPECT_EQ(a.left, b.left);
                EXPECT_EQ(a.right, b.right);
            }
            if (scene.panels[i].row == scene.panels[j].row) {
                EXPECT_EQ(a.top, b.top);
                EXPECT_EQ(a.bottom, b.bottom);
            }
        }
}

TEST(Layout, FirstRowStandsOnTop) {
    const Layout layout = arrange(grid(2, 1));
    EXPECT_GT(layout.panels[0].area.bottom, layout.panels[1].area.top);
}

RC_GTEST_PROP(Layout, NothingOverlapsAndAllStaysOnThePaper, ()) {
    const auto rows = static_cast<std::size_t>(*support::whole_between(1, 4));
    const auto columns = static_cast<std::size_t>(*support::whole_between(1, 3));
    Scene scene = grid(rows, columns);
    scene.height = 40.0 + 35.0 * static_cast<double>(rows);
    scene.caption = {"a caption"};
    scene.legend = {{"squeal", Fill{}}, {"failed", Fill{}}};
    if (*rc::gen::arbitrary<bool>()) scene.colour_bar = ColourBar{"level", "dB", {{0.0, 100.0}, AxisScale::linear}};
    const Layout layout = arrange(scene);
    std::vector<Rectangle> areas;
    for (const PlacedPanel& panel : layout.panels)
        areas.push_back(panel.area);
    for (const PlacedSample& sample : layout.samples)
        areas.push_back(sample.area);
    if (layout.colour_bar) areas.push_back(layout.colour_bar->area);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const Rectangle& a = areas[i];
        RC_ASSERT(a.left >= 0.0 && a.right <= scene.width && a.bottom >= 0.0 && a.top <= scene.height);
        RC_ASSERT(a.left < a.right && a.bottom < a.top);
        for (std::size_t j = 0; j < i; ++j) {
            const Rectangle& b = areas[j];
            RC_ASSERT(a.right < b.left || b.right < a.left || a.top < b.bottom || b.top < a.bottom);
        }
    }
}

TEST(Layout, WideNumbersPushTheirPanelAside) {
    Scene narrow = grid(1, 1);
    Scene wide = grid(1, 1);
    wide.panels[0].y.ticks = {{0.5, "separation of surfaces", TickSize::major}};
    EXPECT_GT(arrange(wide).panels[0].area.left, arrange(narrow).panels[0].area.left + 20.0);
}

TEST(Layout, NumbersStandBesideTheirTicks) {
    Scene scene = grid(1, 1);
    scene.panels[0].y.ticks = {{0.5, "half", TickSize::major}, {2.0, "beyond", TickSize::major}};
    scene.panels[0].x.ticks = {{0.25, "quarter", TickSize::major}};
    const Layout layout = arrange(scene);
    const Rectangle& area = layout.panels[0].area;
    const auto placed = [&](const char* word) {
        return std::find_if(layout.texts.begin(), layout.texts.end(),
                            [&](const PlacedText& each) { return plain_text(each.text) == word; });
    };
    ASSERT_NE(placed("half"), layout.texts.end());
    ASSERT_NE(placed("quarter"), layout.texts.end());
    EXPECT_EQ(placed("beyond"), layout.texts.end());
    EXPECT_DOUBLE_EQ(placed("half")->y, 0.5 * (area.bottom + area.top));
    EXPECT_LT(placed("half")->x, area.left);
    EXPECT_DOUBLE_EQ(placed("quarter")->x, area.left + 0.25 * width_of(area));
    EXPECT_LT(placed("quarter")->y, area.bottom);
    scene.panels[0].y.text = AxisText::hidden;
    EXPECT_EQ(arrange(scene).texts.size(), layout.texts.size() - 2) << "its number and its title";
}

TEST(Layout, LongTitlesAreBroken) {
    Scene scene = grid(1, 1);
    scene.title =
        "a title of very many words that nobody would ever want to read in one line of a paper because it does not fit "
        "there at all, as one can see";
    const double top = arrange(grid(1, 1)).panels[0].area.top;
    EXPECT_LT(arrange(scene).panels[0].area.top, top);
}

}  // namespace
}  // namespace stridor::drawing
