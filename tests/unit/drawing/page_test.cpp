#include "stridor/drawing/page.hpp"

#include "drawn_image.hpp"
#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace stridor::drawing {
namespace {

std::string drawn(Format format, const std::function<void(Page&)>& draw) {
    Page page(40.0, 20.0, format, "title");
    draw(page);
    return page.finished();
}

DrawnImage image(const std::function<void(Page&)>& draw) {
    return DrawnImage(drawn(Format::png, draw));
}

PlacedText word(Align align) {
    return {"Hxo", 20.0, 10.0, align, 12.0, red};
}

TEST(Page, CountsFromItsLowerLeftCorner) {
    const DrawnImage dots = image([](Page& page) { page.fill({5.0, 15.0, 2.0, 6.0}, red); });
    EXPECT_EQ(dots.at(10.0, 4.0), red);
    EXPECT_EQ(dots.at(10.0, 16.0), white);
    EXPECT_EQ(dots.at(20.0, 4.0), white);
}

TEST(Page, IsCoveredByWhatComesLater) {
    const DrawnImage dots = image([](Page& page) {
        page.fill({5.0, 15.0, 2.0, 6.0}, red);
        page.fill({10.0, 20.0, 2.0, 6.0}, blue);
    });
    EXPECT_EQ(dots.at(7.0, 4.0), red);
    EXPECT_EQ(dots.at(12.0, 4.0), blue);
}

TEST(Page, TakesNoInkBesideAClip) {
    const DrawnImage dots = image([](Page& page) {
        page.begin_clip({10.0, 20.0, 5.0, 15.0});
        page.fill({0.0, 40.0, 0.0, 20.0}, red);
        page.end_clip();
        page.fill({30.0, 35.0, 5.0, 15.0}, blue);
    });
    EXPECT_EQ(dots.at(15.0, 10.0), red);
    EXPECT_EQ(dots.at(5.0, 10.0), white);
    EXPECT_EQ(dots.at(32.0, 10.0), blue);
}

TEST(Page, DrawsLinesAsWideAsAsked) {
    const Dot ends[] = {{5.0, 10.0}, {35.0, 10.0}};
    const DrawnImage dots = image([&](Page& page) { page.curve(ends, {red, 12.0, Dash::solid}, LineEnd::butt); });
    const Rectangle ink = dots.inked();
    EXPECT_NEAR(height_of(ink), 12.0 * millimetres_per_point, 0.26) << "a dot above and below is touched";
    EXPECT_NEAR(width_of(ink), 30.0, 0.26);
}

TEST(Page, DashesLinesThatAreNotSolid) {
    const Dot ends[] = {{5.0, 10.0}, {35.0, 10.0}};
    for (const Dash dash : {Dash::solid, Dash::dashed, Dash::dotted}) {
        const DrawnImage dots = image([&](Page& page) { page.curve(ends, {red, 4.0, dash}); });
        int gaps = 0;
        for (double x = 6.0; x < 34.0; x += 0.2)
            gaps += dots.at(x, 10.0) == white ? 1 : 0;
        EXPECT_EQ(gaps > 10, dash != Dash::solid);
    }
}

TEST(Page, DrawsMarksInTheirMiddleAndOfTheirSize) {
    const Dot middle{20.0, 10.0};
    for (const Mark mark : {Mark::disc, Mark::square, Mark::triangle, Mark::diamond, Mark::nabla, Mark::cross}) {
        const DrawnImage dots = image([&](Page& page) { page.marks({&middle, 1}, mark, 20.0, red); });
        EXPECT_EQ(dots.at(20.0, 10.0), red);
        const double diameter = 20.0 * millimetres_per_point;
        EXPECT_NEAR(0.5 * (dots.inked().left + dots.inked().right), 20.0, 0.13);
        EXPECT_GT(width_of(dots.inked()), 0.85 * diameter);
        EXPECT_LT(width_of(dots.inked()), 1.5 * diameter);
    }
}

TEST(Page, WritesWhereTheLayoutSays) {
    const double width = text_width("Hxo", 12.0);
    for (const auto& [align, left] : {std::pair(Align::left, 20.0), std::pair(Align::centre, 20.0 - 0.5 * width),
                                      std::pair(Align::right, 20.0 - width)}) {
        const Rectangle ink = image([align = align](Page& page) { page.text(word(align)); }).inked();
        // letters have some air on their sides
        EXPECT_GE(ink.left, left - 0.13);
        EXPECT_LE(ink.right, left + width + 0.13);
        EXPECT_GT(width_of(ink), 0.8 * width);
        EXPECT_NEAR(0.5 * (ink.bottom + ink.top), 10.0, 0.3) << "12 pt are 4.2 mm";
    }
}

TEST(Page, TurnsTextsUpwards) {
    PlacedText text = word(Align::centre);
    text.turn = PlacedText::Turn::quarter;
    const Rectangle ink = image([&](Page& page) { page.text(text); }).inked();
    EXPECT_GT(height_of(ink), width_of(ink));
    EXPECT_NEAR(0.5 * (ink.bottom + ink.top), 10.0, 0.3);
}

TEST(Page, OfTheSameDrawingIsTheSameFile) {
    const auto draw = [](Page& page) {
        page.text(word(Align::left));
        page.fill({5.0, 15.0, 2.0, 6.0}, red);
    };
    for (const Format format : {Format::png, Format::svg, Format::pdf})
        EXPECT_EQ(drawn(format, draw), drawn(format, draw));
    EXPECT_EQ(drawn(Format::pdf, draw).find("CreationDate"), std::string::npos);
}

TEST(Page, TooLargeForItsFormatIsAnError) {
    const support::Thrown thrown = support::thrown_by([] { Page(1e5, 20.0, Format::png, ""); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("the figure could not be drawn"));
}

}  // namespace
}  // namespace stridor::drawing
