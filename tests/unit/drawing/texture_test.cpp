#include "stridor/drawing/texture.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace stridor::drawing {
namespace {

TEST(Pattern, OfNoTextureIsEmpty) {
    const Rectangle box{0.0, 10.0, 0.0, 10.0};
    const Pattern strokes = pattern(Texture::none, {&box, 1});
    EXPECT_TRUE(strokes.lines.empty());
    EXPECT_TRUE(strokes.dots.empty());
}

TEST(Pattern, CrossesRisingAndFallingLines) {
    const Rectangle box{0.3, 10.0, 0.7, 8.0};
    const std::size_t rising = pattern(Texture::rising, {&box, 1}).lines.size();
    const std::size_t falling = pattern(Texture::falling, {&box, 1}).lines.size();
    EXPECT_EQ(pattern(Texture::crossed, {&box, 1}).lines.size(), rising + falling);
}

TEST(Pattern, RunsOnFromOneRectangleIntoTheNext) {
    const Rectangle whole{0.0, 20.0, 0.0, 10.0};
    const std::vector<Rectangle> parts{{0.0, 7.0, 0.0, 10.0}, {7.0, 20.0, 0.0, 4.0}, {7.0, 20.0, 4.0, 10.0}};
    for (const Texture texture : {Texture::rising, Texture::falling, Texture::dots}) {
        const Pattern one = pattern(texture, {&whole, 1});
        const Pattern cut = pattern(texture, parts);
        EXPECT_EQ(one.lines.size(), cut.lines.size());
        EXPECT_EQ(one.dots.size(), cut.dots.size());
        for (std::size_t i = 0; i < std::min(one.lines.size(), cut.lines.size()); ++i) {
            EXPECT_NEAR(one.lines[i].x0, cut.lines[i].x0, 1e-9);
            EXPECT_NEAR(one.lines[i].x1, cut.lines[i].x1, 1e-9);
        }
    }
}

RC_GTEST_PROP(Pattern, StaysInsideItsRectangle, ()) {
    const double left = *support::number_between(-50.0, 50.0);
    const double bottom = *support::number_between(-50.0, 50.0);
    const Rectangle box{left, left + *support::number_between(0.1, 30.0), bottom,
                        bottom + *support::number_between(0.1, 30.0)};
    const auto holds = [&](double x, double y) {
        constexpr double rounding = 1e-9;
        return x >= box.left - rounding && x <= box.right + rounding && y >= box.bottom - rounding &&
               y <= box.top + rounding;
    };
    for (const Texture texture : {Texture::crossed, Texture::dots}) {
        const Pattern strokes = pattern(texture, {&box, 1});
        for (const Segment& line : strokes.lines)
            RC_ASSERT(holds(line.x0, line.y0) && holds(line.x1, line.y1));
        for (const Dot& dot : strokes.dots)
            RC_ASSERT(holds(dot.x, dot.y));
    }
}

RC_GTEST_PROP(Pattern, ReachesEveryCellOfThreeMillimetres, ()) {
    const double left = *support::number_between(0.0, 20.0);
    const double bottom = *support::number_between(0.0, 20.0);
    const Rectangle box{left, left + 3.0, bottom, bottom + 3.0};
    RC_ASSERT(!pattern(Texture::rising, {&box, 1}).lines.empty());
    RC_ASSERT(!pattern(Texture::falling, {&box, 1}).lines.empty());
    RC_ASSERT(!pattern(Texture::dots, {&box, 1}).dots.empty());
}

}  // namespace
}  // namespace stridor::drawing
