#include "stridor/sweep/boundaries.hpp"

#include "support/property.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace stridor::sweep {
namespace {

using classification::Category;
using classification::Quiet;
using support::whole_between;

// a chart of one direction drawn in letters, its upper row first: n slides, s sticks, d locks (silent),
// l squeal, k squeak, c creak, x failed
SweepResult drawn(const std::vector<std::string>& rows) {
    SweepResult result;
    result.study = small_study();
    result.study.directions = {parameters::Direction::going};
    result.study.x = {"contact.preload", 0.0, static_cast<double>(rows[0].size() - 1), static_cast<int>(rows[0].size()),
                      Scale::linear};
    result.study.y = {"contact.static_friction", 0.0, static_cast<double>(rows.size() - 1),
                      static_cast<int>(rows.size()), Scale::linear};
    const std::map<char, Quiet> silences{{'n', Quiet::slides}, {'s', Quiet::sticks}, {'d', Quiet::locks}};
    const std::map<char, Category> categories{{'l', Category::squeal}, {'k', Category::squeak}, {'c', Category::creak}};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        for (const char letter : *row) {
            CellVerdict& cell = result.cells.emplace_back();
            if (letter == 'x') continue;
            cell.status = Status::done;
            const auto silent = silences.find(letter);
            cell.category = silent == silences.end() ? categories.at(letter) : Category::none;
            if (silent != silences.end()) cell.quiet = silent->second;
        }
    return result;
}

using Point = std::pair<double, double>;

std::vector<Point> points_of(const Boundary& boundary) {
    std::vector<Point> points;
    for (const BoundaryVertex& vertex : boundary.vertices)
        points.emplace_back(vertex.x, vertex.y);
    return points;
}

TEST(Boundaries, AreNotWhereNothingDiffers) {
    EXPECT_TRUE(boundaries(drawn({"nnn", "nnn"})).empty());
}

TEST(Boundaries, RunThroughTheMiddlesBetweenCellsThatDiffer) {
    const std::vector<Boundary> lines = boundaries(drawn({"nll", "nnl", "nnn"}));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].first, "none");
    EXPECT_EQ(lines[0].second, "squeal");
    EXPECT_EQ(lines[0].form, LineForm::open);
    EXPECT_EQ(points_of(lines[0]), (std::vector<Point>{{2.0, 0.5}, {1.5, 1.0}, {1.0, 1.5}, {0.5, 2.0}}));
}

TEST(Boundaries, CloseAroundAnIsland) {
    const std::vector<Boundary> lines = boundaries(drawn({"nnn", "ncn", "nnn"}));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].form, LineForm::closed);
    EXPECT_EQ(points_of(lines[0]), (std::vector<Point>{{1.0, 0.5}, {0.5, 1.0}, {1.0, 1.5}, {1.5, 1.0}}));
}

TEST(Boundaries, MeetAmidACellWhereThreeVerdictsDo) {
    const std::vector<Boundary> lines = boundaries(drawn({"lc", "nn"}));
    ASSERT_EQ(lines.size(), 3U);
    for (const Boundary& line : lines) {
        const std::vector<Point> points = points_of(line);
        ASSERT_EQ(points.size(), 2U);
        EXPECT_TRUE(points.front() == (Point{0.5, 0.5}) || points.back() == (Point{0.5, 0.5}));
    }
    EXPECT_EQ(std::string(lines[2].first) + " " + std::string(lines[2].second), "squeal creak");
}

TEST(Boundaries, LeaveTheNoisyAreaWholeWhereTwoTouchAtACorner) {
    const std::vector<Boundary> rising = boundaries(drawn({"nl", "ln"}));
    ASSERT_EQ(rising.size(), 2U);
    EXPECT_EQ(points_of(rising[0]), (std::vector<Point>{{0.5, 0.0}, {1.0, 0.5}}));
    EXPECT_EQ(points_of(rising[1]), (std::vector<Point>{{0.0, 0.5}, {0.5, 1.0}}));
    const std::vector<Boundary> falling = boundaries(drawn({"ln", "nl"}));
    ASSERT_EQ(falling.size(), 2U);
    EXPECT_EQ(points_of(falling[0]), (std::vector<Point>{{0.5, 0.0}, {0.0, 0.5}}));
}

TEST(Boundaries, SurroundCellsWithoutAResult) {
    const std::vector<Boundary> lines = boundaries(drawn({"nx", "nx"}));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].second, "failed");
}

// a contact that locks is no quiet design; one that sticks is `none` as one that slides is
TEST(Boundaries, PartWhatLocksFromWhatIsQuiet) {
    const std::vector<Boundary> lines = boundaries(drawn({"nsd", "nsd"}));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].first, "none");
    EXPECT_EQ(lines[0].second, "locks");
    EXPECT_EQ(points_of(lines[0]), (std::vector<Point>{{1.5, 0.0}, {1.5, 1.0}}));
}

TEST(Boundaries, SayHowFarOffTheyMayLie) {
    SweepResult result = drawn({"nnl", "nnl"});
    result.study.x = {"contact.preload", 1.0, 100.0, 3, Scale::logarithmic};
    result.study.y = {"contact.static_friction", 0.5, 0.7, 2, Scale::linear};
    const std::vector<Boundary> lines = boundaries(result);
    ASSERT_EQ(lines.size(), 1U);
    const BoundaryVertex& vertex = lines[0].vertices.front();
    // the middle of 10 and 100 in a logarithmic scale; sqrt rounds thrice
    EXPECT_NEAR(vertex.x, std::sqrt(1000.0), 1e-13);
    EXPECT_NEAR(vertex.x_resolution, 100.0 - std::sqrt(1000.0), 1e-13) << "the farther of its neighbours";
    EXPECT_NEAR(vertex.y_resolution, 0.1, 1e-15);
}

TEST(Boundaries, StandByDirectionAndPair) {
    SweepResult result = drawn({"nlc", "nlc"});
    result.study.directions = {parameters::Direction::going, parameters::Direction::coming};
    const std::vector<CellVerdict> cells = result.cells;
    result.cells.insert(result.cells.end(), cells.begin(), cells.end());
    const std::vector<Boundary> lines = boundaries(result);
    ASSERT_EQ(lines.size(), 4U);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_EQ(lines[k].direction, k / 2);
        EXPECT_EQ(lines[k].first, k % 2 == 0 ? "none" : "squeal");
    }
}

RC_GTEST_PROP(Boundaries, PassEveryPairOfNeighboursThatDiffersOnce, ()) {
    const int columns = *whole_between(2, 9);
    std::vector<std::string> rows(static_cast<std::size_t>(*whole_between(2, 9)));
    for (std::string& row : rows)
        for (int k = 0; k < columns; ++k)
            row += "ndlkcx"[*whole_between(0, 5)];
    const SweepResult result = drawn(rows);
    std::set<Point> expected;
    const auto letter = [&](std::size_t iy, std::size_t ix) { return rows[rows.size() - 1 - iy][ix]; };
    for (std::size_t iy = 0; iy < rows.size(); ++iy)
        for (std::size_t ix = 0; ix < rows[0].size(); ++ix) {
            const auto x = static_cast<double>(ix);
            const auto y = static_cast<double>(iy);
            if (ix + 1 < rows[0].size() && letter(iy, ix) != letter(iy, ix + 1)) expected.insert({x + 0.5, y});
            if (iy + 1 < rows.size() && letter(iy, ix) != letter(iy + 1, ix)) expected.insert({x, y + 0.5});
        }
    std::set<Point> found;
    for (const Boundary& line : boundaries(result))
        for (const auto& [x, y] : points_of(line)) {
            const bool is_amid = x != std::floor(x) && y != std::floor(y);
            if (is_amid) continue;
            RC_ASSERT(found.insert({x, y}).second);
        }
    RC_ASSERT(found == expected);
}

}  // namespace
}  // namespace stridor::sweep
