#include "stridor/noise_library/entry_filler.hpp"

#include "stridor/noise_library/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::noise_library {
namespace {

TEST(EntryFiller, UnderstandsOtherWordsAndUnitsInTheName) {
    Entry entry;
    EntryFiller filler(entry);
    filler.take("Normal load [N]", "20");
    filler.take("temp", "23 \u00b0C");
    filler.take("Material", "EPDM, glass");
    EXPECT_EQ(entry.preload, 20.0);
    EXPECT_NEAR(entry.temperature, 23.0, 1e-12);
    EXPECT_EQ(entry.materials, "EPDM, glass");
    ASSERT_EQ(filler.notes("a.csv").size(), 1U);
    EXPECT_EQ(filler.notes("a.csv")[0], "a.csv says preload 20 N, temperature 23 degC, materials EPDM, glass");
}

TEST(EntryFiller, LeavesWhatIsSaidAndWhatIsNoField) {
    Entry entry;
    entry.preload = 5.0;
    EntryFiller filler(entry);
    filler.take("preload", "20 N");
    filler.take("weather", "fine");
    filler.take("category", "squeal");  // Stridor writes it
    EXPECT_EQ(entry.preload, 5.0);
    EXPECT_EQ(entry.category, "");
    EXPECT_TRUE(filler.notes("a.csv").empty());
}

TEST(EntryFiller, TellsWhatItCannotRead) {
    Entry entry;
    EntryFiller filler(entry);
    filler.take("preload", "much");
    EXPECT_TRUE(std::isnan(entry.preload));
    ASSERT_EQ(filler.notes("a.csv").size(), 1U);
    EXPECT_EQ(filler.notes("a.csv")[0], "a.csv says what is not understood and left out: preload is \"much\"");
}

TEST(EntryFiller, ReadsLinesOfSeveral) {
    Entry entry;
    EntryFiller filler(entry);
    filler.take_line("preload: 20 N; rh = 40 %, nothing");
    EXPECT_EQ(entry.preload, 20.0);
    EXPECT_EQ(entry.humidity, 40.0);
}

TEST(DriveFacts, HaveTheGreatestVelocityToSixDigits) {
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::sinusoidal;
    drive.amplitude = 0.02;
    drive.frequency = 1.0;
    EXPECT_EQ(peak_velocity(drive), 0.125664);  // 0.04 pi
    EXPECT_EQ(profile_of(drive), "sinusoidal 1 Hz");
    drive.kind = parameters::DriveKind::constant;
    drive.velocity = -0.1;
    EXPECT_EQ(peak_velocity(drive), 0.1);
    EXPECT_EQ(profile_of(drive), "constant");
    drive.kind = parameters::DriveKind::trapezoidal;
    EXPECT_EQ(peak_velocity(drive), 0.1);
    EXPECT_EQ(profile_of(drive), "trapezoidal 1 Hz");
    drive.kind = parameters::DriveKind::sampled;
    EXPECT_TRUE(std::isnan(peak_velocity(drive)));
    EXPECT_EQ(profile_of(drive), "");
}

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
