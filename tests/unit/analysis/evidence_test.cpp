#include "stridor/analysis/evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

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

const EvidenceFigure& figure(std::string_view name) {
    const auto figures = evidence_figures();
    return *std::find_if(figures.begin(), figures.end(), [&](const EvidenceFigure& each) { return each.name == name; });
}

TEST(EvidenceFigures, HaveNamesAndKeysOfTheirOwn) {
    std::set<std::string_view> names;
    std::set<std::string_view> keys;
    for (const EvidenceFigure& each : evidence_figures()) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_TRUE(keys.insert(each.key).second) << each.key;
        EXPECT_FALSE(each.unit.empty()) << each.name;
        EXPECT_FALSE(each.sentence.empty()) << each.name;
    }
}

TEST(EvidenceFigures, AreReadFromTheEvidence) {
    Evidence evidence;
    evidence.rates = {0.5, 0.25, 0.125};
    evidence.judged_rates = {0.75, 0.0625, 0.03125};
    evidence.alternation.intervals = 7;
    evidence.alternation.lag = 3;
    evidence.releases = 9;
    evidence.levels.plate.peak_decibels = 120.0;
    const std::map<std::string_view, double> expected{{"slip", 0.5},
                                                      {"stick", 0.25},
                                                      {"separation", 0.125},
                                                      {"judged_slip", 0.75},
                                                      {"judged_stick", 0.0625},
                                                      {"judged_separation", 0.03125},
                                                      {"intervals", 7.0},
                                                      {"lag", 3.0},
                                                      {"releases", 9.0},
                                                      {"plate_peak_level", 120.0}};
    for (const auto& [name, value] : expected)
        EXPECT_EQ(figure(name).value(evidence), value) << name;
}

TEST(EvidenceFigures, ShareTheUnitOfTheirObject) {
    EXPECT_EQ(unit_key(figure("judged_stick")), "judged_rates");
    EXPECT_EQ(unit_key(figure("regularity")), "regularity");
    EXPECT_EQ(unit_key(figure("joint_rms")), "levels.rms");
    EXPECT_EQ(unit_key(figure("plate_peak_level")), "levels.peak_level");
    EXPECT_EQ(unit_key(figure("releases")), "");
}

// one unit for all that share a key of it
TEST(EvidenceFigures, OfOneUnitKeyHaveOneUnit) {
    std::map<std::string, std::string_view> units;
    for (const EvidenceFigure& each : evidence_figures()) {
        const std::string key = unit_key(each);
        if (key.empty()) continue;
        EXPECT_EQ(units.emplace(key, each.unit).first->second, each.unit) << each.name;
    }
}

}  // namespace
}  // namespace stridor::analysis
