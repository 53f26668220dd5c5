#include "stridor/drawing/palette.hpp"

#include "stridor/pictures/parts/category_colours.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace stridor::drawing {
namespace {

using classification::Category;
using model::ContactState;
using Triple = std::array<double, 3>;

constexpr std::array categories{Category::none, Category::squeak, Category::squeal, Category::creak};
constexpr std::array states{ContactState::slip, ContactState::stick, ContactState::separation};

double linear(double channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// linear sRGB as eyes of one kind see it: Machado, Oliveira, Fernandes 2009, severity 1
using Sight = std::array<Triple, 3>;
constexpr std::array<Sight, 4> sights{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

// CIE L*a*b* (D65) of a colour seen by one kind of eyes
Triple lab(Colour colour, const Sight& sight) {
    const Triple light{linear(colour.red), linear(colour.green), linear(colour.blue)};
    Triple seen{};
    for (std::size_t i = 0; i < 3; ++i)
        seen[i] = std::clamp(sight[i][0] * light[0] + sight[i][1] * light[1] + sight[i][2] * light[2], 0.0, 1.0);
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f((0.4124564 * seen[0] + 0.3575761 * seen[1] + 0.1804375 * seen[2]) / 0.95047);
    const double y = f(0.2126729 * seen[0] + 0.7151522 * seen[1] + 0.0721750 * seen[2]);
    const double z = f((0.0193339 * seen[0] + 0.1191920 * seen[1] + 0.9503041 * seen[2]) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

double hue(double a, double b) {
    const double degrees = std::atan2(b, a) * 180.0 / std::numbers::pi;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

double seventh_power_share(double chroma) {
    return std::sqrt(std::pow(chroma, 7) / (std::pow(chroma, 7) + std::pow(25.0, 7)));
}

// CIEDE2000 (Sharma, Wu, Dalal 2005)
double distance(const Triple& p, const Triple& q) {
    const double stretch = 1.5 - 0.5 * seventh_power_share(0.5 * (std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])));
    const double chroma_p = std::hypot(stretch * p[1], p[2]);
    const double chroma_q = std::hypot(stretch * q[1], q[2]);
    const double hue_p = hue(stretch * p[1], p[2]);
    const double hue_q = hue(stretch * q[1], q[2]);
    const double turn = std::remainder(hue_q - hue_p, 360.0);
    const double L = 0.5 * (p[0] + q[0]);
    const double C = 0.5 * (chroma_p + chroma_q);
    const double sum = hue_p + hue_q;
    const double H = std::abs(hue_p - hue_q) <= 180.0 ? 0.5 * sum : 0.5 * (sum + 360.0);
    const double T = 1.0 - 0.17 * std::cos(radians(H - 30.0)) + 0.24 * std::cos(radians(2.0 * H)) +
                     0.32 * std::cos(radians(3.0 * H + 6.0)) - 0.20 * std::cos(radians(4.0 * H - 63.0));
    const double off = (L - 50.0) * (L - 50.0);
    const double light = (q[0] - p[0]) / (1.0 + 0.015 * off / std::sqrt(20.0 + off));
    const double chroma = (chroma_q - chroma_p) / (1.0 + 0.045 * C);
    const double tone = 2.0 * std::sqrt(chroma_p * chroma_q) * std::sin(radians(0.5 * turn)) / (1.0 + 0.015 * C * T);
    const double bend = 60.0 * std::exp(-std::pow((H - 275.0) / 25.0, 2));
    const double mixed = -2.0 * seventh_power_share(C) * std::sin(radians(bend)) * chroma * tone;
    return std::sqrt(light * light + chroma * chroma + tone * tone + mixed);
}

double least_distance(Colour one, Colour other) {
    double least = 1e9;
    for (const Sight& sight : sights)
        least = std::min(least, distance(lab(one, sight), lab(other, sight)));
    return least;
}

TEST(ColourDistance, AgreesWithThePublishedTestData) {
    // Sharma, Wu, Dalal 2005, Table 1, pairs 1 and 17
    EXPECT_NEAR(distance({50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(distance({50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}), 27.1492, 1e-4);
}

TEST(Palette, CategoriesDifferForEveryKindOfEyes) {
    for (std::size_t i = 0; i < categories.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(least_distance(pictures::category_fill(categories[i]).colour,
                                     pictures::category_fill(categories[j]).colour),
                      21.0)
                << i << " " << j;
}

TEST(Palette, CategoriesDifferInGrey) {
    for (std::size_t i = 0; i < categories.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(std::abs(lightness(pictures::category_fill(categories[i]).colour) -
                               lightness(pictures::category_fill(categories[j]).colour)),
                      18.5)
                << i << " " << j;
}

TEST(Palette, ContactStatesDifferAmongThemselvesAndFromCategories) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GE(least_distance(pictures::state_colour(states[i]), pictures::state_colour(states[j])), 30.0)
                << i << " " << j;
            EXPECT_GE(
                std::abs(lightness(pictures::state_colour(states[i])) - lightness(pictures::state_colour(states[j]))),
                25.0);
        }
        for (const Category category : categories)
            EXPECT_GE(least_distance(pictures::state_colour(states[i]), pictures::category_fill(category).colour), 14.5)
                << i;
    }
}

TEST(Palette, EveryKindOfCellButNoneHasItsOwnLookWithoutColour) {
    EXPECT_EQ(pictures::category_fill(Category::none).texture, Texture::none);
    const std::vector<Fill> fills{pictures::category_fill(Category::squeak), pictures::category_fill(Category::squeal),
                                  pictures::category_fill(Category::creak),
                                  pictures::category_fill(Category::undecided), pictures::failed_fill()};
    for (std::size_t i = 0; i < fills.size(); ++i) {
        EXPECT_NE(fills[i].texture, Texture::none) << i;
        // the strokes can be seen on their ground
        EXPECT_GE(std::abs(lightness(fills[i].ink) - lightness(fills[i].colour)), 25.0) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(fills[i].texture == fills[j].texture && fills[i].colour == fills[j].colour) << i << " " << j;
    }
}

TEST(Palette, NoVerdictLooksLikeAFailure) {
    for (const Category category : categories) {
        EXPECT_NE(pictures::category_fill(category).colour, pictures::failed_fill().colour);
        EXPECT_NE(pictures::category_fill(category).colour, pictures::category_fill(Category::undecided).colour);
    }
}

TEST(Sequential, GrowsEvenlyLighter) {
    constexpr int steps = 50;
    const double whole = lightness(sequential(1.0)) - lightness(sequential(0.0));
    for (int i = 0; i < steps; ++i) {
        const double step = lightness(sequential((i + 1.0) / steps)) - lightness(sequential(i * 1.0 / steps));
        // 11 control points rounded to 8 bits: each step within a third of the mean one
        EXPECT_NEAR(step, whole / steps, whole / steps / 3.0 + 0.4) << i;
    }
    EXPECT_EQ(sequential(-1.0), sequential(0.0));
    EXPECT_EQ(sequential(2.0), sequential(1.0));
}

TEST(TextColour, CanBeReadOnEveryFill) {
    for (const Category category : categories) {
        const Colour ground = pictures::category_fill(category).colour;
        EXPECT_GE(std::abs(lightness(text_colour_on(ground)) - lightness(ground)), 45.0);
    }
}

TEST(Hex, WritesSixDigits) {
    EXPECT_EQ(hex({0xDD, 0xAA, 0x03}), "#DDAA03");
}

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
