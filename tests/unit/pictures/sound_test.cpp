#include "stridor/pictures/sound.hpp"

#include "pictures_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::pictures {
namespace {

sound::SoundAnalysis felt_channel() {
    sound::SoundAnalysis analysis;
    analysis.unit = "m/s";
    analysis.duration = 6.0;
    analysis.rate = 48000.0;
    analysis.spectrum = {100.0, 150.0, "m/s", std::vector<double>(241, 1e-6), 1};
    analysis.spectrogram = {0.5, 6000.0, 4, "m/s", std::vector<double>(48, 1e-6)};
    analysis.waveform = {3.0, {{-0.5, 0.25}, {-0.1, 0.1}}};
    return analysis;
}

sound::SoundAnalysis heard_channel() {
    sound::SoundAnalysis analysis = felt_channel();
    analysis.unit = analysis.spectrogram.unit = "FS";
    analysis.passages.resize(2);
    analysis.passages[0].tones.pitch = {{1.0, 2000.0}, {1.02, 2010.0}};
    analysis.passages[0].onsets.instants = {0.5, 2.5};
    analysis.passages[1].onsets.instants = {3.5, 4.5, 5.5};
    analysis.impulses = {0.5, 3000.0, 4, "FS", std::vector<double>(24, 1e-5), 3.0};
    return analysis;
}

std::vector<double> instants_of(const drawing::Panel& panel) {
    std::vector<double> instants;
    for (const drawing::Line& line : layers_of<drawing::Line>(panel))
        for (std::size_t k = 0; k < line.x.size(); k += 3)
            instants.push_back(line.x[k]);
    return instants;
}

}  // namespace

TEST(SoundPicture, ShowsOfAMotionNeitherTracksNorShortFrames) {
    const drawing::Scene scene = sound(felt_channel(), {});
    ASSERT_EQ(scene.panels.size(), 4U);
    EXPECT_EQ(scene.panels[2].layers.size(), 1U);
    EXPECT_TRUE(layers_of<drawing::Boxes>(scene.panels[0]).empty());
}

TEST(SoundPicture, DrawsTheStrongestToneAndTheOnsetsWhereTheyAre) {
    const drawing::Scene scene = sound(heard_channel(), {});
    ASSERT_EQ(scene.panels.size(), 5U);
    const auto points = layers_of<drawing::Points>(scene.panels[2]);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].x, (std::vector{1.0, 1.02}));
    EXPECT_EQ(points[0].y, (std::vector{2000.0, 2010.0}));
    EXPECT_EQ(instants_of(scene.panels[2]), (std::vector{0.5, 2.5, 3.5, 4.5, 5.5}));
    EXPECT_GT(scene.panels[2].y.range.to, 24000.0) << "the onsets stand above the spectrogram";
}

TEST(SoundPicture, ShowsTheLoudestPassageThroughShortFrames) {
    const drawing::Scene scene = sound(heard_channel(), {});
    const drawing::Panel& impulses = scene.panels[4];
    EXPECT_EQ(impulses.x.range, (drawing::Extent{3.0, 6.0}));
    EXPECT_EQ(instants_of(impulses), (std::vector{3.5, 4.5, 5.5}));
    const auto looked_at = layers_of<drawing::Boxes>(scene.panels[0]);
    ASSERT_EQ(looked_at.size(), 1U);
    EXPECT_EQ(looked_at[0].boxes[0].x, impulses.x.range);
}

TEST(SoundPicture, HasOneColourScaleForBothSpectrograms) {
    const drawing::Scene scene = sound(heard_channel(), {});
    const auto harmonics = layers_of<drawing::ValueCells>(scene.panels[2]);
    const auto impulses = layers_of<drawing::ValueCells>(scene.panels[4]);
    ASSERT_EQ(harmonics.size() + impulses.size(), 2U);
    EXPECT_EQ(harmonics[0].colours.range, impulses[0].colours.range);
    EXPECT_EQ(scene.colour_bar->colours.range, impulses[0].colours.range);
    EXPECT_DOUBLE_EQ(impulses[0].colours.range.to, -50.0) << "of the stronger one";
    EXPECT_DOUBLE_EQ(impulses[0].x_edges.front(), 3.0);
}

TEST(SoundPicture, SaysHowProbableTheVerdictIsAndWhy) {
    classification::RecordingVerdict verdict;
    verdict.category = classification::Category::creak;
    verdict.reasons = {"90 % of the energy, probability 0.87"};
    verdict.passages.resize(1);
    verdict.segments.resize(1);
    verdict.segments[0].verdict.category = classification::Category::creak;
    verdict.segments[0].verdict.reasons = {"creak with 87 %: train 0.90 (+1.2)"};
    const drawing::Scene scene = sound(heard_channel(), verdict);
    ASSERT_EQ(scene.caption.size(), 2U);
    EXPECT_NE(drawing::plain_text(scene.caption[0]).find("heard as creak; 90 % of the energy, probability 0.87"),
              std::string::npos);
    EXPECT_EQ(drawing::plain_text(scene.caption[1]), "creak with 87 %: train 0.90 (+1.2)");
}

}  // namespace stridor::pictures
