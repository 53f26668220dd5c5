#include "stridor/noise_library/entry_filler.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stridor::noise_library
