#include "stridor/pictures/parts/boundary_line.hpp"

#include "pictures_support.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::pictures {
namespace {

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

}  // namespace
}  // namespace stridor::pictures
