#include "stridor/analysis/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stridor::analysis {
namespace {

// a sinusoid of velocity amplitude v over a time T: integral of its square v^2 T / 2
record::Vibration sinusoid(double amplitude, double time) {
    return {0.5 * amplitude * amplitude * time, amplitude * amplitude};
}

TEST(Levels, OfASinusoid) {
    record::Tally tally;
    tally.vibration = {sinusoid(0.2, 3.0), {}, sinusoid(1e-3, 3.0)};
    tally.vibration_time = 3.0;
    const Levels result = levels(tally);
    EXPECT_DOUBLE_EQ(result.joint.rms, 0.2 / std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(result.joint.peak, 0.2);
    // 20 log10 of the amplitude over 1e-9 m/s, less 3.0103 dB for the root mean square
    EXPECT_NEAR(result.plate.peak_decibels, 120.0, 1e-12);
    EXPECT_NEAR(result.plate.decibels, 120.0 - 10.0 * std::log10(2.0), 1e-12);
    EXPECT_NEAR(result.joint.decibels, 166.02059991327963 - 3.010299956639812, 1e-12);
}

TEST(Levels, OfTheJointJoinBothDirections) {
    record::Tally tally;
    tally.vibration = {sinusoid(3.0, 2.0), sinusoid(4.0, 2.0), {}};
    tally.vibration[0].peak_square = tally.vibration[1].peak_square = 25.0;  // in phase
    tally.vibration_time = 2.0;
    EXPECT_DOUBLE_EQ(levels(tally).joint.rms, 5.0 / std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(levels(tally).joint.peak, 5.0);
}

// a steady velocity squares to itself but for rounding, and a peak between sampled instants is not seen
TEST(Levels, PeakIsAtLeastTheRootMeanSquare) {
    record::Tally tally;
    tally.vibration = {{3.0 * 0.01, std::nextafter(0.01, 0.0)}, {}, {2.0, 0.0}};
    tally.vibration_time = 3.0;
    EXPECT_GE(levels(tally).joint.peak, levels(tally).joint.rms);
    EXPECT_EQ(levels(tally).plate.peak, levels(tally).plate.rms);
}

TEST(Levels, AtRestAreMinusInfinity) {
    record::Tally tally;
    tally.vibration.resize(3);
    tally.vibration_time = 1.0;
    EXPECT_EQ(levels(tally).plate.rms, 0.0);
    EXPECT_EQ(levels(tally).plate.decibels, -std::numeric_limits<double>::infinity());
}

// 1 nm/s is far below hearing, and what rounding leaves is no level
TEST(Levels, BelowZeroDecibelsAreNotTold) {
    record::Tally tally;
    tally.vibration = {{}, {}, {1.0001e-18, 1e-18}};
    tally.vibration_time = 1.0;
    EXPECT_NEAR(levels(tally).plate.decibels, 0.0, 1e-3);
    tally.vibration.back().square_time = 0.9999e-18;
    EXPECT_EQ(levels(tally).plate.decibels, -std::numeric_limits<double>::infinity());
    EXPECT_NEAR(levels(tally).plate.rms, 1e-9, 1e-13);
}

TEST(Levels, OfNoJudgedTimeAreUnknown) {
    record::Tally tally;
    tally.vibration.resize(3);
    EXPECT_TRUE(std::isnan(levels(tally).joint.rms));
    EXPECT_TRUE(std::isnan(levels(tally).joint.decibels));
    EXPECT_TRUE(std::isnan(levels(tally).joint.peak));
    EXPECT_TRUE(std::isnan(levels(tally).joint.peak_decibels));
}

}  // namespace
}  // namespace stridor::analysis
