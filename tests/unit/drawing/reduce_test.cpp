#include "stridor/drawing/reduce.hpp"

#include "stridor/drawing/ticks.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace stridor::drawing {
namespace {

PanelAxis unit_axis() {
    PanelAxis axis;
    axis.range = {0.0, 1.0};
    return axis;
}

// lowest and highest y of each column, -1 and `columns` standing for what lies outside
std::map<int, Extent> extremes(const Line& line, int columns) {
    std::map<int, Extent> found;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (std::isnan(line.y[i])) continue;
        const int column = static_cast<int>(std::floor(std::clamp(line.x[i] * columns, -1.0, columns * 1.0)));
        const auto [place, is_new] = found.try_emplace(column, Extent{line.y[i], line.y[i]});
        place->second = {std::min(place->second.from, line.y[i]), std::max(place->second.to, line.y[i])};
    }
    return found;
}

RC_GTEST_PROP(Reduced, KeepsTheExtremesOfEveryColumn, ()) {
    const int count = *support::whole_between(1, 400);
    const int columns = *support::whole_between(1, 20);
    Line line;
    for (int i = 0; i < count; ++i) {
        line.x.push_back(-0.2 + 1.4 * i / count);
        line.y.push_back(*support::signed_fraction());
    }
    const Line kept = reduced(line, unit_axis(), static_cast<std::size_t>(columns));
    RC_ASSERT(kept.x.size() == kept.y.size());
    RC_ASSERT(kept.x.size() <= 4U * (static_cast<std::size_t>(columns) + 2U));
    RC_ASSERT(std::is_sorted(kept.x.begin(), kept.x.end()));
    RC_ASSERT(extremes(kept, columns).size() == extremes(line, columns).size());
    for (const auto& [column, range] : extremes(line, columns))
        RC_ASSERT(extremes(kept, columns).at(column) == range);
}

TEST(Reduced, KeepsAnImpactOfOneSample) {
    Line line;
    for (int i = 0; i < 100000; ++i) {
        line.x.push_back(i * 1e-5);
        line.y.push_back(i == 43210 ? -2.5e5 : std::sin(0.01 * i));
    }
    const Line kept = reduced(line, unit_axis(), 500);
    EXPECT_LE(kept.x.size(), 2000U);
    EXPECT_EQ(*std::min_element(kept.y.begin(), kept.y.end()), -2.5e5);
    EXPECT_EQ(kept.x.front(), line.x.front());
    EXPECT_EQ(kept.x.back(), line.x.back());
}

TEST(Reduced, StaysPartedAtMissingPoints) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const Line line{{0.1, 0.2, 0.3, 0.4, 0.5}, {1.0, nothing, nothing, 2.0, 3.0}, {}};
    const Line kept = reduced(line, unit_axis(), 10);
    ASSERT_EQ(kept.y.size(), 4U);
    EXPECT_TRUE(std::isnan(kept.y[1]));
    EXPECT_EQ(kept.y[2], 2.0);
}

TEST(Shades, OfAWholeRowAreOneBox) {
    const Strip strip{{{0.0, 0.4, 1}, {0.4, 1.0, 1}}, {{}, {}, {}}};
    const std::vector<Shade> boxes = shades(strip, {0.0, 1.0}, 100);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_EQ(boxes[0].row, 1U);
    EXPECT_EQ(boxes[0].share, 1.0);
    EXPECT_NEAR(boxes[0].x.to - boxes[0].x.from, 1.0, 1e-12);
}

TEST(Shades, TellTheShareOfTimeInAColumn) {
    // alternating stays, 1:3, far shorter than a column
    Strip strip{{}, {{}, {}}};
    for (int i = 0; i < 1000; ++i) {
        strip.intervals.push_back({i * 1e-3, i * 1e-3 + 0.25e-3, 0});
        strip.intervals.push_back({i * 1e-3 + 0.25e-3, (i + 1) * 1e-3, 1});
    }
    for (const Shade& shade : shades(strip, {0.0, 1.0}, 10))
        EXPECT_NEAR(shade.share, shade.row == 0 ? 0.25 : 0.75, 1.0 / 8.0);
}

RC_GTEST_PROP(Shades, NeverLoseAnInterval, ()) {
    const double from = *support::number_between(0.0, 1.0);
    const double length = *rc::gen::element(0.0, 1e-12, 1e-6, 0.01);
    const double to = std::min(1.0, from + length);
    const Strip strip{{{from, to, 0}}, {{}}};
    const std::vector<Shade> boxes = shades(strip, {0.0, 1.0}, 137);
    RC_ASSERT(!boxes.empty());
    RC_ASSERT(boxes.front().x.from <= from + 1e-9);
    RC_ASSERT(boxes.back().x.to >= to - 1e-9);
    RC_ASSERT(boxes.front().share > 0.0);
}

TEST(Shades, LeaveOutWhatLiesOutside) {
    const Strip strip{{{-2.0, -1.0, 0}, {3.0, 4.0, 0}}, {{}}};
    EXPECT_TRUE(shades(strip, {0.0, 1.0}, 10).empty());
}

RC_GTEST_PROP(CellRuns, CoverEachCellOnceWithItsKind, ()) {
    const int columns = *support::whole_between(1, 8);
    const int rows = *support::whole_between(1, 8);
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= columns; ++i)
        x.push_back(i);
    for (int i = 0; i <= rows; ++i)
        y.push_back(i);
    std::vector<std::uint16_t> kinds;
    for (int i = 0; i < columns * rows; ++i)
        kinds.push_back(static_cast<std::uint16_t>(*support::whole_between(0, 2)));
    const std::vector<CellRun> runs = cell_runs(x, y, kinds);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto holds = [&](const CellRun& run) {
                return run.box.x.from <= column && column + 1 <= run.box.x.to && run.box.y.from == row;
            };
            RC_ASSERT(std::count_if(runs.begin(), runs.end(), holds) == 1);
            const auto kind = kinds[static_cast<std::size_t>(row * columns + column)];
            RC_ASSERT(std::find_if(runs.begin(), runs.end(), holds)->kind == kind);
        }
}

}  // namespace
}  // namespace stridor::drawing
