#include "stridor/pictures/held_numbers.hpp"

#include "pictures_support.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>
#include <vector>

namespace stridor::pictures {
namespace {

constexpr std::array<std::string_view, 2> kinds{"formula", "measurement"};

TEST(HeldNumbers, HasABarAndAPointForEachNumber) {
    const std::vector<HeldPoint> numbers{{"amplitude", "1 | 1.001", 0, 1e-2, 1e-3},
                                         {"period", "2 | 2.2", 1, 1e-2, 0.1}};
    const drawing::Scene scene = held_numbers(numbers, kinds);
    const std::vector<drawing::Boxes> bars = layers_of<drawing::Boxes>(scene.panels.at(0));
    ASSERT_EQ(bars.size(), 1U);
    ASSERT_EQ(bars[0].boxes.size(), 2U);
    EXPECT_EQ(bars[0].boxes[0].x.to, 1e-2);
    const std::vector<drawing::Points> points = layers_of<drawing::Points>(scene.panels.at(0));
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].x, std::vector<double>{1e-3});
    EXPECT_GT(points[0].y[0], points[1].y[0]);  // the first stands at the top
    EXPECT_NE(points[0].mark, points[1].mark);
    EXPECT_EQ(scene.legend.size(), 3U);
}

TEST(HeldNumbers, WritesNoNumbersUnderTheirPoint) {
    const std::vector<HeldPoint> numbers{{"near", "1 | 1", 0, 1e-6, 1e-10}, {"far", "1 | 1.1", 0, 0.2, 0.1}};
    const drawing::Scene scene = held_numbers(numbers, kinds);
    const std::vector<drawing::Note> notes = layers_of<drawing::Note>(scene.panels.at(0));
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_GT(notes[0].x, 1e-6);
    EXPECT_LT(notes[1].x, 1e-12);
}

TEST(HeldNumbers, KeepsWhatIsEqualAtTheEdge) {
    const std::vector<HeldPoint> numbers{{"rest", "1 | 1", 0, 1e-9, 0.0}};
    const drawing::Scene scene = held_numbers(numbers, kinds);
    EXPECT_EQ(layers_of<drawing::Points>(scene.panels.at(0)).at(0).x[0], scene.panels[0].x.range.from);
    EXPECT_EQ(scene.legend.size(), 2U);  // of the kinds only those that are drawn
}

}  // namespace
}  // namespace stridor::pictures
