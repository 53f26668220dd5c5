#include "stridor/pictures/stability.hpp"

#include "pictures_support.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::pictures {
namespace {

using analysis::StabilityKind;

// two frequencies that meet at 0.5 and part into a growing and a decaying mode, listed in either order
analysis::StabilityPath coupling() {
    analysis::StabilityPath path;
    for (int i = 0; i <= 100; ++i) {
        const double value = i / 100.0;
        const double apart = std::sqrt(std::abs(0.5 - value));
        analysis::SlidingStability stability;
        if (value < 0.5) {
            stability.modes = {{0.0, 600.0 - 100.0 * apart}, {0.0, 600.0 + 100.0 * apart}};
        } else {
            stability.kind = StabilityKind::flutter;
            stability.modes = {{900.0 * apart, 600.0}, {-900.0 * apart, 600.0}};
            if (i % 2 == 0) std::swap(stability.modes[0], stability.modes[1]);
        }
        path.points.push_back({value, stability});
    }
    path.boundaries = {{0.5, StabilityKind::stable, StabilityKind::flutter, 600.0}};
    return path;
}

analysis::StabilityScan scan_of(std::vector<analysis::DirectionScan> directions) {
    analysis::StabilityScan scan;
    scan.base.title = "seal 4711";
    scan.key = "contact.kinetic_friction";
    scan.unit = "1";
    scan.directions = std::move(directions);
    return scan;
}

analysis::DirectionScan going() {
    return {parameters::Direction::going, {}, coupling(), {}};
}

TEST(StabilityScene, ShowsFrequencyAndGrowthPerDirection) {
    const drawing::Scene scene = stability(scan_of({going(), {parameters::Direction::coming, {}, {}, {}}}));
    EXPECT_EQ(drawing::plain_text(scene.title), "Stability of steady sliding: seal 4711");
    ASSERT_EQ(scene.panels.size(), 4U);
    EXPECT_EQ(drawing::plain_text(scene.panels[2].title), "b) coming");
    EXPECT_EQ(scene.panels[0].y.unit, "Hz");
    EXPECT_EQ(scene.panels[1].y.unit, "1/s");
    EXPECT_EQ(drawing::plain_text(scene.panels[1].x.label), "kinetic friction μd");
}

TEST(StabilityScene, LinesFollowTheModesWhateverTheirOrder) {
    const drawing::Scene scene = stability(scan_of({going()}));
    const std::vector<drawing::Line> growths = layers_of<drawing::Line>(scene.panels[1]);
    ASSERT_EQ(growths.size(), 2U);
    for (const drawing::Line& line : growths) {
        ASSERT_EQ(line.y.size(), 101U);
        const double sign = line.y.back() > 0.0 ? 1.0 : -1.0;
        for (std::size_t i = 52; i < line.y.size(); ++i)
            EXPECT_GT(sign * line.y[i], sign * line.y[i - 1]) << i;
    }
}

TEST(StabilityScene, NamesTheOnsetAndTintsWhatIsUnstable) {
    const drawing::Scene scene = stability(scan_of({going()}));
    EXPECT_EQ(drawing::plain_text(scene.panels[0].title), "a) going: μd = 0.5");
    for (const drawing::Panel& panel : scene.panels) {
        const std::vector<drawing::Boxes> grounds = layers_of<drawing::Boxes>(panel);
        ASSERT_EQ(grounds.size(), 1U);
        EXPECT_EQ(grounds[0].boxes.at(0).x, (drawing::Extent{0.5, 1.0}));
    }
}

}  // namespace
}  // namespace stridor::pictures
