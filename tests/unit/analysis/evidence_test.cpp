#include "stridor/analysis/evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::analysis {
namespace {

TEST(Evidence, KeepsWholeAndJudgedTimeApart) {
    record::Tally tally;
    tally.phase = record::Phase::coming;
    tally.contacts.front().time = {6.0, 1.0, 1.0};
    tally.contacts.front().judged_time = {1.0, 3.0, 0.0};
    tally.vibration.resize(3);
    tally.closing_vibration.resize(3);
    tally.vibration_time = 4.0;
    const Evidence figures = evidence(tally, 0);
    EXPECT_EQ(figures.phase, record::Phase::coming);
    EXPECT_EQ(figures.window_time, 8.0);
    EXPECT_EQ(figures.judged_time, 4.0);
    EXPECT_EQ(figures.rates.slip, 0.75);
    EXPECT_EQ(figures.judged_rates.stick, 0.75);
    EXPECT_EQ(figures.alternation.intervals, 0);
    EXPECT_EQ(figures.levels.joint.rms, 0.0);
}

// a second of judged time of which the last fifth is ten times quieter
record::Tally fading() {
    record::Tally tally;
    tally.contacts.front().time = tally.contacts.front().judged_time = {1.0, 0.0, 0.0};
    tally.vibration = {{0.8 + 0.2 * 0.01, 1.0}, {0.0, 0.0}, {0.0, 0.0}};
    tally.vibration_time = 1.0;
    tally.closing_vibration = {{0.2 * 0.01, 0.01}, {0.0, 0.0}, {0.0, 0.0}};
    tally.closing_time = 0.2;
    return tally;
}

TEST(Evidence, GivesTheLevelsOfTheEndWhereNothingChangesAnyMore) {
    record::Tally tally = fading();
    EXPECT_NEAR(evidence(tally, 0).levels.joint.rms, 0.1, 1e-15);
    tally.contacts.front().judged_time = {0.9, 0.1, 0.0};
    EXPECT_NEAR(evidence(tally, 0).levels.joint.rms, std::sqrt(0.802), 1e-15);
    tally.contacts.front().ending.outlook.future = record::Future::slides;
    EXPECT_NEAR(evidence(tally, 0).levels.joint.rms, 0.1, 1e-15);
}

// the plate carries a stuck joint along: only what moves across the contact is vibration
TEST(Evidence, TakesNoMotionOfThePlateForVibrationOfAStuckJoint) {
    record::Tally tally = fading();
    tally.contacts.front().judged_time = {0.0, 1.0, 0.0};
    tally.closing_vibration[2] = {0.2 * 0.04, 0.04};
    EXPECT_NEAR(evidence(tally, 0).levels.joint.rms, 0.2, 1e-15);
    EXPECT_NEAR(evidence(tally, 0).levels.joint.peak, 0.2, 1e-15);
}

TEST(Evidence, CountsWhatEndsSticks) {
    record::Tally tally = fading();
    using enum model::ContactState;
    tally.contacts.front().changes[record::change_kind(stick, slip)].count = 3;
    tally.contacts.front().changes[record::change_kind(stick, separation)].count = 2;
    tally.contacts.front().changes[record::change_kind(slip, stick)].count = 7;
    tally.contacts.front().releases = 9;
    EXPECT_EQ(evidence(tally, 0).releases, 5);
    EXPECT_EQ(evidence(tally, 0).all_releases, 9);
}

TEST(Evidence, IsThatOfTheContactAskedFor) {
    record::Tally tally = fading();
    tally.contacts.resize(2);
    tally.vibration.resize(5);
    tally.closing_vibration.resize(5);
    tally.contacts[1].time = tally.contacts[1].judged_time = {0.0, 1.0, 0.0};
    EXPECT_EQ(evidence(tally, 0).rates.slip, 1.0);
    EXPECT_EQ(evidence(tally, 1).rates.stick, 1.0);
    EXPECT_EQ(evidence(tally, 1).contact, 1U);
}

}  // namespace
}  // namespace stridor::analysis
