#include "stridor/drawing/labels.hpp"

#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::drawing {
namespace {

// a map of cells of 5 mm by 5 mm
struct Example {
    CategoryCells cells;
    Panel panel;
    Rectangle area;
    std::vector<StyledText> names{"none", "squeal"};
};

Example example(int columns, int rows) {
    Example map;
    for (int i = 0; i <= columns; ++i)
        map.cells.x_edges.push_back(i);
    for (int i = 0; i <= rows; ++i)
        map.cells.y_edges.push_back(i);
    map.cells.kinds.assign(static_cast<std::size_t>(columns * rows), 0);
    map.cells.fills = {pictures::category_fill(classification::Category::none),
                       pictures::category_fill(classification::Category::squeal)};
    map.panel.x.range = {0.0, columns * 1.0};
    map.panel.y.range = {0.0, rows * 1.0};
    map.area = {10.0, 10.0 + 5.0 * columns, 20.0, 20.0 + 5.0 * rows};
    return map;
}

std::vector<Note> names_of(const Example& map) {
    return region_names(map.cells, map.names, map.panel, map.area, 8.0);
}

TEST(RegionNames, NameEachLargeRegionOnce) {
    Example map = example(10, 8);
    for (std::size_t i = 0; i < map.cells.kinds.size(); ++i)
        map.cells.kinds[i] = i % 10 < 5 ? 0 : 1;
    const std::vector<Note> notes = names_of(map);
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(plain_text(notes[0].text), "none");
    EXPECT_LT(notes[0].x, 0.5);
    EXPECT_EQ(plain_text(notes[1].text), "squeal");
    EXPECT_GT(notes[1].x, 0.5);
    EXPECT_EQ(notes[1].ground, map.cells.fills[1].colour);
}

TEST(RegionNames, LeaveOutWhatIsTooSmall) {
    Example map = example(10, 8);
    map.cells.kinds[34] = 1;
    const std::vector<Note> notes = names_of(map);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(plain_text(notes[0].text), "none");
}

TEST(RegionNames, RegionsMeetBySidesNotByCorners) {
    Example map = example(10, 8);
    for (std::size_t i = 0; i < map.cells.kinds.size(); ++i)
        map.cells.kinds[i] = (i % 10 < 5) == (i / 10 < 4) ? 0 : 1;
    EXPECT_EQ(names_of(map).size(), 4U);
}

RC_GTEST_PROP(RegionNames, StandOnCellsOfTheirKindOnly, ()) {
    Example map = example(12, 8);
    for (std::uint16_t& kind : map.cells.kinds)
        kind = *support::whole_between(0, 9) == 0 ? 1U : 0U;
    for (const Note& note : names_of(map)) {
        const TextExtent extent = note_extent(note.text, 8.0);
        const std::size_t kind = plain_text(note.text) == "none" ? 0 : 1;
        const double x = note.x * 12.0;
        const double y = note.y * 8.0;
        const auto first = [](double value) { return static_cast<int>(std::floor(value + 1e-9)); };
        for (int row = first(y - extent.height / 10.0); row <= first(y + extent.height / 10.0 - 2e-9); ++row)
            for (int column = first(x - extent.width / 10.0); column <= first(x + extent.width / 10.0 - 2e-9); ++column)
                RC_ASSERT(map.cells.kinds[static_cast<std::size_t>(row * 12 + column)] == kind);
    }
}

}  // namespace
}  // namespace stridor::drawing
