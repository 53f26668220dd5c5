#include "stridor/noise_library/heard_figures.hpp"

#include "stridor/noise_library/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::noise_library {
namespace {

double value_in(const std::vector<Figure>& figures, const std::string& name) {
    for (const Figure& figure : figures)
        if (figure.name == name) return figure.value;
    return unknown;
}

classification::RecordingVerdict creaking(double mean_square) {
    classification::RecordingVerdict verdict;
    verdict.category = classification::Category::creak;
    classification::SoundSegment segment;
    segment.mean_square = mean_square;
    segment.impulses = {0.1, 0.2, 0.3};
    segment.impulse_interval = 0.1;
    segment.impulse_regularity = 0.987654321;
    segment.verdict.category = classification::Category::creak;
    segment.verdict.features.frequency = 431.0;
    segment.verdict.features.tonality = std::nan("");
    verdict.segments = {segment};
    return verdict;
}

TEST(HeardFigures, AreOfTheLoudestSegmentToSixDigits) {
    sound::SoundAnalysis analysis;
    analysis.unit = "Pa";
    const std::vector<Figure> figures = figures_of(analysis, creaking(4e-4));
    EXPECT_NEAR(value_in(figures, "level"), 60.0, 1e-4);  // [dB] 0.02 Pa over 20 uPa
    EXPECT_EQ(value_in(figures, "dominant_frequency"), 431.0);
    EXPECT_EQ(value_in(figures, "impulses"), 3.0);
    EXPECT_EQ(value_in(figures, "impulse_regularity"), 0.987654);
    EXPECT_TRUE(std::isnan(value_in(figures, "tonality")));  // what is not known is no figure
}

TEST(HeardFigures, OfSilenceHaveNoFeatures) {
    const std::vector<Figure> figures = figures_of(sound::SoundAnalysis{}, creaking(0.0));
    EXPECT_TRUE(std::isnan(value_in(figures, "impulses")));
    EXPECT_TRUE(figures_of(sound::SoundAnalysis{}, classification::RecordingVerdict{}).empty());
}

TEST(FrictionFigures, LeaveOutWhatWasNotMeasured) {
    analysis::FrictionFigures found;
    found.static_friction.value = 0.45;
    found.kinetic_friction.value = std::nan("");
    found.drops = 12;
    const std::vector<Figure> figures = figures_of(found);
    EXPECT_EQ(value_in(figures, "static_friction"), 0.45);
    EXPECT_EQ(value_in(figures, "force_drops"), 12.0);
    EXPECT_TRUE(std::isnan(value_in(figures, "kinetic_friction")));
}

TEST(AddMissing, LeavesWhatAPersonWrote) {
    Entry entry;
    set_figure(entry, {"level", "dB", 50.0});
    add_missing(entry, std::vector<Figure>{{"level", "dB", 60.0}, {"rest", "1", 0.5}});
    EXPECT_EQ(number_of(entry, "level"), 50.0);
    EXPECT_EQ(number_of(entry, "rest"), 0.5);
}

}  // namespace
}  // namespace stridor::noise_library
