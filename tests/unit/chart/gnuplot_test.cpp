#include "stridor/chart/gnuplot.hpp"

#include "chart_support.hpp"
#include "stridor/chart/noise_chart.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace stridor::chart {
namespace {

using support::thrown_by;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

// a number of a PNG header: four bytes, highest first
unsigned big_endian(const std::string& bytes, std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value * 256U + static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// PATH as a test sets it, until the end of the block
class OtherPath {
public:
    explicit OtherPath(const std::string& path) : before_(std::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
    ~OtherPath() { ::setenv("PATH", before_.c_str(), 1); }
    OtherPath(const OtherPath&) = delete;
    OtherPath& operator=(const OtherPath&) = delete;

private:
    std::string before_;
};

class Drawing : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(can_draw()) << "gnuplot is not installed; ./dev setup installs it"; }

    Scene scene = noise_chart(quiet_sweep());
};

TEST_F(Drawing, IsAPngOfTheScenesSize) {
    const std::string bytes = render(scene, Format::png);
    ASSERT_GT(bytes.size(), 5000U);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_NEAR(big_endian(bytes, 16), scene.width / 25.4 * png_resolution, 0.5);
    EXPECT_NEAR(big_endian(bytes, 20), scene.height / 25.4 * png_resolution, 0.5);
}

TEST_F(Drawing, IsAnSvgWithItsTextsAsWritten) {
    scene.title = "mu_d 'a' @b {c} <d> & ^e ~f \\g %h";
    const std::string text = render(scene, Format::svg);
    EXPECT_EQ(text.substr(0, 5), "<?xml");
    EXPECT_EQ(count(text, "<svg"), 1U);
    EXPECT_EQ(count(text, "</svg>"), 1U);
    EXPECT_EQ(count(text, "<g") - count(text, "<g/"), count(text, "</g>"));
    EXPECT_EQ(count(text, "<text"), count(text, "</text>"));
    EXPECT_TRUE(text.find("mu_d 'a' @b {c} &lt;d> &amp; ^e ~f \\g %h") != std::string::npos);
    EXPECT_EQ(count(text, "<text>"), 0U) << "blanks at the ends of styled runs are kept";
}

TEST_F(Drawing, OfTheSameSceneIsTheSameFile) {
    for (const Format format : {Format::png, Format::svg})
        EXPECT_EQ(render(scene, format), render(scene, format));
}

TEST_F(Drawing, OfAnEmptyPanelHasAxes) {
    Scene empty;
    empty.panels.emplace_back();
    EXPECT_FALSE(render(empty, Format::svg).empty());
}

TEST(Draw, KnowsOnlyPngAndSvg) {
    EXPECT_EQ(format_of("a/chart.png"), Format::png);
    EXPECT_EQ(format_of("chart.svg"), Format::svg);
    const support::Thrown thrown = thrown_by([] { format_of("chart.jpeg"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("cannot draw into chart.jpeg"));
}

TEST(Draw, WithoutGnuplotSaysWhatToInstall) {
    const support::ScratchFolder folder;
    const OtherPath nothing(folder.path());
    EXPECT_FALSE(can_draw());
    const support::Thrown thrown = thrown_by([] { render({}, Format::png); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("gnuplot is not installed"));
    EXPECT_TRUE(thrown.says("gnuplot-nox"));
}

TEST(Draw, PassesOnWhatGnuplotComplainsOf) {
    const support::ScratchFolder folder(support::Medium::disk);
    // a gnuplot that reads nothing and fails
    std::ofstream(folder / "gnuplot") << "#!/bin/sh\nprintf 'plot x\\n     ^\\nline 7: undefined variable: x\\n' >&2\n"
                                         "exit 1\n";
    std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
    const OtherPath stand_in(folder.path());
    Scene scene = noise_chart(quiet_sweep());
    const support::Thrown thrown = thrown_by([&] { render(scene, Format::png); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("(line 7: undefined variable: x)")) << thrown.message;
}

}  // namespace
}  // namespace stridor::chart
