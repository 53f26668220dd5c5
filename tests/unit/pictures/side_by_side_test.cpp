#include "stridor/pictures/side_by_side.hpp"

#include "pictures_support.hpp"
#include "stridor/drawing/layout.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::pictures {
namespace {

using classification::ComparedSound;

ComparedSound recording() {
    ComparedSound sound;
    sound.label = "vehicle";
    sound.origin = "recording";
    sound.analysis.duration = 2.0;
    sound.analysis.rate = 48000.0;
    sound.analysis.spectrum = {100.0, 150.0, "FS", std::vector<double>(241, 1e-6), 1};
    sound.analysis.spectrogram = {0.5, 6000.0, 4, "FS", std::vector<double>(16, 1e-6)};
    sound.analysis.waveform = {1.0, {{-0.5, 0.25}, {-0.1, 0.1}}};
    sound.profile.features.mean_square = 1.0;
    sound.detail = {0.5, {48000.0, "FS", std::vector<double>(480, 0.1)}};
    return sound;
}

ComparedSound simulation() {
    ComparedSound sound = recording();
    sound.label = "model";
    sound.contact.verdicts.emplace_back();
    sound.contact.verdicts.front().category = classification::Category::squeal;
    sound.contact.histories = {{{model::ContactState::slip, 0.5, 0.504}, {model::ContactState::stick, 0.504, 0.51}}};
    return sound;
}

}  // namespace

TEST(SideBySide, GivesEachSoundAColumnOnOneFrequencyAxis) {
    const std::vector<ComparedSound> sounds{recording(), recording(), simulation()};
    const drawing::Scene scene = side_by_side(sounds);
    ASSERT_EQ(scene.column_widths.size(), 3U);
    ASSERT_EQ(scene.panels.size(), 18U);
    EXPECT_EQ(scene.panels[1].y.range, scene.panels[13].y.range);
    EXPECT_EQ(scene.panels[0].y.text, drawing::AxisText::shown);
    EXPECT_EQ(scene.panels[6].y.text, drawing::AxisText::hidden);
    EXPECT_EQ(drawing::plain_text(scene.panels[12].title), "c) model");
}

TEST(SideBySide, ShowsContactStatesOnlyWhereTheyAreKnown) {
    const drawing::Scene scene = side_by_side(std::vector{recording(), simulation()});
    EXPECT_TRUE(layers_of<drawing::Strip>(scene.panels[4]).empty());
    const auto strips = layers_of<drawing::Strip>(scene.panels[10]);
    ASSERT_EQ(strips.size(), 1U);
    EXPECT_NEAR(strips[0].intervals[1].from, 4.0, 1e-9) << "[ms] from the detail's beginning";
    EXPECT_EQ(side_by_side(std::vector{recording()}).panels.size(), 5U);
}

TEST(SideBySide, HasAColourBarBesideTheSpectrogramsOnly) {
    const drawing::Scene scene = side_by_side(std::vector{recording(), simulation()});
    const drawing::Layout layout = drawing::arrange(scene);
    ASSERT_TRUE(layout.colour_bar);
    EXPECT_EQ(layout.colour_bar->area.bottom, layout.panels[1].area.bottom);
    EXPECT_EQ(layout.colour_bar->area.top, layout.panels[1].area.top);
}

TEST(SideBySide, DrawsSilenceWithoutASpectrogram) {
    ComparedSound silent = recording();
    silent.profile = {};
    const drawing::Scene scene = side_by_side(std::vector{recording(), silent});
    EXPECT_EQ(layers_of<drawing::ValueCells>(scene.panels[1]).size(), 1U);
    EXPECT_TRUE(layers_of<drawing::ValueCells>(scene.panels[6]).empty());
}

}  // namespace stridor::pictures
