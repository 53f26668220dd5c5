#include "stridor/pictures/sensitivity.hpp"

#include "pictures_support.hpp"

#include <gtest/gtest.h>

#include <set>

namespace stridor::pictures {
namespace {

using noise_library::Entry;
using noise_library::unknown;

noise_library::Sensitivity over_preload() {
    std::vector<Entry> entries(4);
    const double preloads[] = {2.0, 40.0, 40.0, 100.0};
    const char* const categories[] = {"none", "squeal", "squeal", "creak"};
    for (std::size_t k = 0; k < entries.size(); ++k) {
        entries[k].id = static_cast<std::int64_t>(k) + 1;
        entries[k].preload = preloads[k];
        entries[k].category = categories[k];
        entries[k].figures = {{"level", "dB", 50.0 + static_cast<double>(k)}};
    }
    return sensitivity(entries, {});
}

TEST(SensitivityScene, ShowsWhatTheRecordsHaveOverOneAxis) {
    const drawing::Scene scene = sensitivity(over_preload());
    ASSERT_EQ(scene.panels.size(), 2U) << "no record has a frequency";
    EXPECT_EQ(drawing::plain_text(scene.panels[1].y.label), "level");
    EXPECT_EQ(scene.panels[1].y.unit, "dB");
    EXPECT_EQ(scene.panels[1].x.unit, "N");
    EXPECT_EQ(scene.panels[0].x.range, scene.panels[1].x.range);
    EXPECT_EQ(scene.panels[1].x.scale, drawing::AxisScale::logarithmic) << "2 to 100 N";
}

TEST(SensitivityScene, TellsCategoriesByColourAndMark) {
    const drawing::Scene scene = sensitivity(over_preload());
    std::set<drawing::Mark> marks;
    std::set<std::size_t> sizes;
    for (const drawing::Points& points : layers_of<drawing::Points>(scene.panels[1])) {
        marks.insert(points.mark);
        sizes.insert(points.x.size());
    }
    EXPECT_EQ(marks.size(), 3U);
    EXPECT_EQ(sizes, (std::set<std::size_t>{1, 2}));
    EXPECT_EQ(scene.legend.size(), 3U);
}

TEST(SensitivityScene, PutsRecordsOfOneValueBesideEachOther) {
    const std::vector<drawing::Points> rows = layers_of<drawing::Points>(sensitivity(over_preload()).panels[0]);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1].x, (std::vector<double>{40.0, 40.0}));
    EXPECT_NE(rows[1].y[0], rows[1].y[1]);
    for (const double y : rows[1].y)
        EXPECT_TRUE(y > 1.0 && y < 2.0) << y;
}

}  // namespace
}  // namespace stridor::pictures
