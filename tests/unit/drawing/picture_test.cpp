#include "stridor/drawing/picture.hpp"

#include "drawn_image.hpp"
#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "support/error_text.hpp"
#include "unit/pictures/pictures_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace stridor::drawing {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

// one panel from 0 to 1 and 0 to 2
Scene scene_of(std::vector<Layer> layers) {
    Scene scene;
    Panel panel;
    panel.x.label = symbol("mu_d");
    panel.y.range = {0.0, 2.0};
    panel.layers = std::move(layers);
    scene.panels.push_back(panel);
    return scene;
}

// the picture of such a scene, asked in the panel's own units
class Drawn {
public:
    explicit Drawn(const Scene& scene)
        : panel_(scene.panels.front()),
          area_(arrange(scene).panels.front().area),
          image_(render(scene, Format::png)) {}

    Colour at(double x, double y) const {
        return image_.at(area_.left + position(panel_.x, x) * width_of(area_),
                         area_.bottom + position(panel_.y, y) * height_of(area_));
    }

    const Rectangle& area() const { return area_; }
    const DrawnImage& image() const { return image_; }

private:
    Panel panel_;
    Rectangle area_;
    DrawnImage image_;
};

TEST(Picture, IsAPngOfTheScenesSize) {
    const Scene scene = pictures::noise_chart(pictures::quiet_sweep());
    const std::string bytes = render(scene, Format::png);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_NEAR(DrawnImage(bytes).width(), scene.width / 25.4 * png_resolution, 0.5);
    EXPECT_NEAR(DrawnImage(bytes).height(), scene.height / 25.4 * png_resolution, 0.5);
}

TEST(Picture, IsAnSvgThatHoldsItsWords) {
    Scene scene = pictures::noise_chart(pictures::quiet_sweep());
    scene.title = "mu_d 'a' @b {c} <d> & ^e ~f \\g %h\n\x01";
    const std::string text = render(scene, Format::svg);
    EXPECT_EQ(text.substr(0, 5), "<?xml");
    EXPECT_EQ(count(text, "<svg"), 1U);
    EXPECT_EQ(count(text, "</svg>"), 1U);
    EXPECT_EQ(count(text, "<title>mu_d 'a' @b {c} &lt;d&gt; &amp; ^e ~f \\g %h  </title>"), 1U);
    EXPECT_NE(text.find("kinetic friction", text.find("<desc>")), std::string::npos);
    EXPECT_EQ(text.find("font-family"), std::string::npos) << "it looks the same without the font";
}

TEST(Picture, IsAPdfWithItsTitle) {
    Scene scene = scene_of({});
    scene.title = "squeal";
    const std::string bytes = render(scene, Format::pdf);
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_NE(bytes.find("/Title (squeal)"), std::string::npos);
}

TEST(Picture, OfTheSameSceneIsTheSameFile) {
    const Scene scene = pictures::noise_chart(pictures::quiet_sweep());
    for (const Format format : {Format::png, Format::svg, Format::pdf})
        EXPECT_EQ(render(scene, format), render(scene, format));
}

TEST(Picture, OfAnEmptyPanelHasAxes) {
    const Drawn drawn(scene_of({}));
    const double tick = 0.4;  // [mm]
    EXPECT_NE(drawn.image().at(drawn.area().left - tick, drawn.area().bottom), white);
    EXPECT_EQ(drawn.at(0.53, 1.03), white);
}

TEST(Picture, PutsValuesWhereTheirAxisHasThem) {
    Scene scene = scene_of({Points{{10.0}, {0.5}, red, 6.0, std::nullopt}});
    scene.panels[0].x.range = {1.0, 1000.0};
    scene.panels[0].x.scale = AxisScale::logarithmic;
    const Drawn drawn(scene);
    EXPECT_EQ(drawn.at(10.0, 0.5), red);
    EXPECT_EQ(drawn.image().at(drawn.area().left + width_of(drawn.area()) / 3.0,
                               drawn.area().bottom + height_of(drawn.area()) / 4.0),
              red);
}

TEST(Picture, PartsALineAtMissingPoints) {
    const Drawn drawn(scene_of({Line{{0.0, 0.2, 0.5, 0.8, 1.0}, {1.1, 1.1, nothing, 1.1, 1.1}, {red, 4.0}}}));
    EXPECT_EQ(drawn.at(0.1, 1.1), red);
    EXPECT_EQ(drawn.at(0.53, 1.1), white);
    EXPECT_EQ(drawn.at(0.9, 1.1), red);
}

TEST(Picture, EndsALineAtThePanelHoweverFarItGoes) {
    const Drawn drawn(scene_of({Line{{0.25, 0.25}, {0.0, 1e200}, {red, 4.0}}}));
    EXPECT_EQ(drawn.at(0.25, 1.9), red);
    const Rectangle& area = drawn.area();
    EXPECT_EQ(drawn.image().at(area.left + 0.25 * width_of(area), area.top + 1.0), white);
}

TEST(Picture, LeavesOutPointsBeyondThePanel) {
    const Drawn drawn(scene_of({Points{{1.02, nothing}, {1.03, 1.0}, red, 20.0, std::nullopt}}));
    EXPECT_EQ(drawn.at(0.99, 1.03), white);
}

TEST(Picture, FillsCellsWithTheirColourAndTexture) {
    const Fill plain{blue, Texture::none, {}};
    const Fill hatched{red, Texture::rising, {255, 255, 255}};
    const Drawn drawn(scene_of({CategoryCells{{0.0, 0.5, 1.0}, {0.0, 2.0}, {0, 1}, {plain, hatched}}}));
    int plain_dots = 0;
    int hatched_dots = 0;
    for (double y = 0.2; y < 1.8; y += 0.005) {
        plain_dots += drawn.at(0.25, y) == blue ? 0 : 1;
        hatched_dots += drawn.at(0.75, y) == red ? 0 : 1;
    }
    EXPECT_EQ(plain_dots, 0);
    EXPECT_GT(hatched_dots, 20);
    EXPECT_LT(hatched_dots, 160) << "the texture leaves most of the colour";
}

TEST(Picture, LeavesNoHairlineBetweenCells) {
    CategoryCells cells{{}, {0.0, 2.0}, {}, {{blue, Texture::none, {}}, {red, Texture::none, {}}}};
    for (int i = 0; i <= 37; ++i)
        cells.x_edges.push_back(i / 37.0);
    for (std::uint16_t i = 0; i < 37; ++i)
        cells.kinds.push_back(i % 2);
    const Drawn drawn(scene_of({cells}));
    // at an edge the two mix; nothing of the paper shines through
    for (double x = 0.02; x < 0.98; x += 0.0005)
        ASSERT_LE(drawn.at(x, 1.03).green, 20) << x;
}

TEST(Picture, FillsValuesFromTheScaleAndMissingOnesApart) {
    const Fill missing{red, Texture::none, {}};
    const Drawn drawn(scene_of({ValueCells{{0.0, 0.5, 1.0}, {0.0, 2.0}, {1.0, nothing}, {{0.0, 1.0}}, missing}}));
    EXPECT_EQ(drawn.at(0.75, 1.03), red);
    EXPECT_GT(drawn.at(0.25, 1.03).red, 240) << "the bright end of viridis";
}

TEST(Picture, RingsPointsThatHaveARim) {
    Points points{{0.53}, {1.03}, red, 10.0, std::nullopt};
    const double ring = 7.5 * millimetres_per_point;  // from the middle: beyond 5 pt, within 10 pt
    const auto beside = [&](const Drawn& drawn) {
        return drawn.image().at(drawn.area().left + 0.53 * width_of(drawn.area()) + ring,
                                drawn.area().bottom + 0.515 * height_of(drawn.area()));
    };
    EXPECT_EQ(beside(Drawn(scene_of({points}))), white);
    points.rim = blue;
    const Drawn ringed(scene_of({points}));
    EXPECT_EQ(beside(ringed), blue);
    EXPECT_EQ(ringed.at(0.53, 1.03), red) << "the ring lies below";
}

TEST(Picture, KeepsTexturesAwayFromNotes) {
    const Fill hatched{red, Texture::crossed, {255, 255, 255}};
    Note note{"n", 0.5, 0.5, Anchor::panel, Align::centre, red, 0.0, std::nullopt};
    const auto white_dots = [&] {
        const Drawn drawn(scene_of({Boxes{{{{0.0, 1.0}, {0.0, 2.0}}}, hatched}, note}));
        int dots = 0;
        for (double x = 0.495; x < 0.505; x += 0.0005)
            for (double y = 0.97; y < 1.03; y += 0.001)
                dots += drawn.at(x, y) == white ? 1 : 0;
        return dots;
    };
    EXPECT_GT(white_dots(), 0);
    note.ground = red;
    EXPECT_EQ(white_dots(), 0);
}

TEST(Picture, ShowsASampleOfEachLegendEntry) {
    Scene scene = scene_of({});
    scene.legend = {{"fill", Fill{red, Texture::none, {}}}, {"stroke", Stroke{blue, 4.0, Dash::solid}}};
    const DrawnImage image(render(scene, Format::png));
    const std::vector<PlacedSample> samples = arrange(scene).samples;
    const auto middle = [&](std::size_t i) {
        const Rectangle& area = samples[i].area;
        return image.at(0.5 * (area.left + area.right), 0.5 * (area.bottom + area.top));
    };
    EXPECT_EQ(middle(0), red);
    EXPECT_EQ(middle(1), blue);
}

TEST(Picture, StaysSmallForALongTrace) {
    Line trace;
    for (int i = 0; i < 1000000; ++i) {
        trace.x.push_back(i * 1e-6);
        trace.y.push_back(i % 7);
    }
    EXPECT_LT(render(scene_of({trace}), Format::svg).size(), 200000U);
}

TEST(FormatOf, KnowsPngSvgAndPdf) {
    EXPECT_EQ(format_of("a/chart.png"), Format::png);
    EXPECT_EQ(format_of("chart.svg"), Format::svg);
    EXPECT_EQ(format_of("chart.pdf"), Format::pdf);
    const support::Thrown thrown = support::thrown_by([] { format_of("chart.jpeg"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("cannot draw into chart.jpeg"));
}

}  // namespace
}  // namespace stridor::drawing
