#include "stridor/chart/script.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

namespace stridor::chart {
namespace {

Scene line_scene() {
    Scene scene;
    Panel panel;
    panel.x.label = symbol("mu_d");
    panel.y.range = {0.0, 2.0};
    panel.layers.emplace_back(Line{{0.0, 0.5, 1.0}, {0.0, 1.0, 2.0}, {}});
    scene.panels.push_back(panel);
    return scene;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(GnuplotString, LeavesNoCharacterThatMeansSomethingToGnuplot) {
    EXPECT_EQ(gnuplot_string("mu_d^2 {x} @y &z ~w \\n"), "'mu\\_d\\^2 \\{x\\} \\@y \\&z \\~w \\\\n'");
    EXPECT_EQ(gnuplot_string("it's"), "'it''s'");
    EXPECT_EQ(gnuplot_string("two\nlines\t"), "'two lines '");
}

TEST(GnuplotString, MarksStylesOnlyWhereAsked) {
    EXPECT_EQ(gnuplot_string(symbol("mu_d")), "'{/:Italic μ}_{d}'");
    EXPECT_EQ(gnuplot_string(unit_text("m/s^2")), "'m/s^{2}'");
}

RC_GTEST_PROP(GnuplotString, CannotBeLeft, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::element('\'', '"', '\\', '\n', '`', '$', 'a', ';'));
    const std::string result = gnuplot_string(text);
    RC_ASSERT(result.front() == '\'' && result.back() == '\'' && result.size() >= 2U);
    RC_ASSERT(result.find('\n') == std::string::npos);
    // inside single quotes only a doubled quote is a quote: runs of quotes have even length
    const std::string inside = result.substr(1, result.size() - 2);
    for (std::size_t at = 0; at < inside.size();) {
        std::size_t end = at;
        while (end < inside.size() && inside[end] == '\'')
            ++end;
        RC_ASSERT((end - at) % 2 == 0U);
        at = end + 1;
    }
}

TEST(Script, NoTextBecomesACommand) {
    Scene scene = line_scene();
    scene.title = "'\nset output 'stolen'\nsystem 'ls' `ls` #";
    scene.panels[0].title = scene.title;
    scene.panels[0].layers.emplace_back(Note{scene.title, 0.5, 0.5, Anchor::panel, Align::left, {}, 0.0, std::nullopt});
    scene.legend.push_back({scene.title, Stroke{}});
    std::istringstream lines(script(scene, Format::svg));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_NE(line.substr(0, 10), "set output");
        EXPECT_NE(line.substr(0, 6), "system");
    }
}

TEST(Script, OfTheSameSceneIsTheSameText) {
    EXPECT_EQ(script(line_scene(), Format::png), script(line_scene(), Format::png));
    EXPECT_NE(script(line_scene(), Format::png), script(line_scene(), Format::svg));
}

TEST(Script, NamesNoFile) {
    EXPECT_FALSE(has(script(line_scene(), Format::png), "set output"));
}

TEST(Script, TickLabelsAreNoNumberFormats) {
    Scene scene = line_scene();
    scene.panels[0].x.ticks = {{0.5, "50 %", TickSize::major}};
    EXPECT_TRUE(has(script(scene, Format::png), "'50 %%' 0.5"));
}

TEST(Script, AxesHaveTheirOwnScale) {
    Scene scene = line_scene();
    EXPECT_FALSE(has(script(scene, Format::png), "set logscale x"));
    scene.panels[0].x.scale = AxisScale::logarithmic;
    scene.panels[0].x.range = {0.1, 10.0};
    EXPECT_TRUE(has(script(scene, Format::png), "set logscale x"));
}

TEST(Script, MissingPointsPartALine) {
    Scene scene = line_scene();
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    scene.panels[0].layers = {Line{{0.0, 0.2, 0.5, 1.0}, {1.0, nothing, 1.0, 2.0}, {}}};
    EXPECT_TRUE(has(script(scene, Format::png), "0 1\n\n0.5 1\n1 2\n"));
    EXPECT_FALSE(has(script(scene, Format::png), "nan"));
}

TEST(Script, FillsCellsWithTheirColourAndTexture) {
    Scene scene = line_scene();
    const Fill plain{{0x01, 0x02, 0x03}, Texture::none, {}};
    const Fill hatched{{0x04, 0x05, 0x06}, Texture::rising, {0x0A, 0x0B, 0x0C}};
    scene.panels[0].layers = {CategoryCells{{0.0, 0.5, 1.0}, {0.0, 2.0}, {0, 1}, {plain, hatched}}};
    const std::string text = script(scene, Format::png);
    EXPECT_TRUE(has(text, " " + std::to_string(0x010203) + "\n"));
    EXPECT_TRUE(has(text, " " + std::to_string(0x040506) + "\n"));
    EXPECT_TRUE(has(text, "#0A0B0C"));
}

TEST(Script, RingsPointsThatHaveARim) {
    Scene scene = line_scene();
    const Points plain{{0.5}, {1.0}, {0x01, 0x02, 0x03}, 2.0, std::nullopt};
    scene.panels[0].layers = {plain};
    scene.legend.push_back({Text("points"), plain});
    EXPECT_TRUE(has(script(scene, Format::png), "size screen"));
    EXPECT_FALSE(has(script(scene, Format::png), "#0A0B0C"));
    Points ringed = plain;
    ringed.rim = Colour{0x0A, 0x0B, 0x0C};
    scene.panels[0].layers = {ringed};
    const std::string text = script(scene, Format::png);
    ASSERT_TRUE(has(text, "#0A0B0C"));
    EXPECT_LT(text.find("lc rgb '#0A0B0C'"), text.find("lc rgb '#010203'")) << "the ring lies below";
}

TEST(Script, StaysSmallForALongTrace) {
    Scene scene = line_scene();
    Line trace;
    for (int i = 0; i < 1000000; ++i) {
        trace.x.push_back(i * 1e-6);
        trace.y.push_back(i % 7);
    }
    scene.panels[0].layers = {trace};
    EXPECT_LT(script(scene, Format::svg).size(), 200000U);
}

}  // namespace
}  // namespace stridor::chart
