#include "stridor/parameters/rules/check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace stridor::parameters {
namespace {

Case sampled_case() {
    Case c;
    c.drive.kind = DriveKind::sampled;
    c.drive.times = {0.0, 0.5, 1.0};
    c.drive.velocities = {0.0, 0.1, 0.0};
    return c;
}

Case constant_case() {
    Case c;
    c.drive.kind = DriveKind::constant;
    return c;
}

// the case has one finding, on this key, and its text holds these words
void expect_finding(const Case& c, const std::string& key, const std::string& words) {
    const std::vector<Finding> found = findings(c);
    ASSERT_EQ(found.size(), 1U) << key;
    EXPECT_EQ(found.front().key, key);
    const base::Problem& problem = found.front().problem;
    const std::string text = problem.what + " | " + problem.why + " | " + problem.suggestion;
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(Findings, AreNoneForWhatCanBeSimulated) {
    EXPECT_TRUE(findings(Case{}).empty());
    EXPECT_TRUE(findings(constant_case()).empty());
    EXPECT_TRUE(findings(sampled_case()).empty());
}

TEST(Findings, KineticFrictionMayNotExceedStatic) {
    Case c;
    c.contact().kinetic_friction = 0.9;
    expect_finding(c, "contact.kinetic_friction", "mu_d = 0.9 exceeds mu_s = 0.8");
    c.contact().kinetic_friction = 0.8;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Findings, KineticFrictionMayNotExceedStaticTheOtherWayEither) {
    Case c;
    c.contact().static_friction_coming = 0.3;
    EXPECT_TRUE(findings(c).empty());  // Coulomb's law has one way for both
    c.contact().friction = FrictionKind::directional;
    expect_finding(c, "contact.kinetic_friction_coming", "mu_dc = 0.6 exceeds mu_sc = 0.3");
    c.contact().kinetic_friction_coming = 0.3;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Findings, NoSampledDriveIsFasterThanAnySurface) {
    for (const double velocity : {1e15, -1e200, std::numeric_limits<double>::infinity()}) {
        Case c = sampled_case();
        c.drive.velocities.at(1) = velocity;
        expect_finding(c, "drive.file", "sample 2 of the sampled drive is");
    }
}

TEST(Findings, AConstantDriveMustMove) {
    Case c = constant_case();
    c.drive.velocity = 0.0;
    expect_finding(c, "drive.velocity", "must not be 0");
    c.drive.velocity = -1e-9;
    EXPECT_TRUE(findings(c).empty());
}

// of every kind of drive that has a velocity, and of no other
TEST(Findings, ATrapezoidalDriveMustMove) {
    Case c;
    c.drive.velocity = 0.0;
    EXPECT_TRUE(findings(c).empty());
    c.drive.kind = DriveKind::trapezoidal;
    expect_finding(c, "drive.velocity", "must not be 0");
}

TEST(Findings, ARampTakesAQuarterOfThePeriodAtMost) {
    Case c;
    c.drive.kind = DriveKind::trapezoidal;
    EXPECT_TRUE(findings(c).empty());
    c.drive.ramp = 0.05;  // at 5 Hz: a triangle
    EXPECT_TRUE(findings(c).empty());
    c.drive.ramp = 0.051;
    expect_finding(c, "drive.ramp", "at most 0.05 s");
    c.drive.ramp = 1e-10;
    expect_finding(c, "drive.ramp", "cannot tell its ends apart");
}

TEST(Findings, ATrapezoidalDriveStartsStill) {
    Case c;
    c.drive.kind = DriveKind::trapezoidal;
    c.run.initial = Initial::sliding;
    expect_finding(c, "run.initial", "stands still at the start");
}

TEST(Findings, AWindowHoldsOneAndAHalfPeriods) {
    Case c;
    c.run.window = 0.29;  // at 5 Hz one and a half periods are 0.3 s
    expect_finding(c, "run.window", "at least 0.3");
    c.run.window = 0.3;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Findings, AWindowFitsIntoTheDuration) {
    Case c = constant_case();
    c.run.duration = 0.5;
    expect_finding(c, "run.window", "longer than run.duration = 0.5 s");
}

TEST(Findings, AStepFitsIntoTheDuration) {
    Case c = constant_case();
    c.run.engine = Engine::beta_2;
    c.run.step = 2.0;
    expect_finding(c, "run.step", "longer than run.duration");
    c.run.step = 1e-13;
    expect_finding(c, "run.step", "1e12 steps");
}

TEST(Findings, SamplesAreAVelocityOverTime) {
    Case c = sampled_case();
    c.drive.times.pop_back();
    expect_finding(c, "drive.file", "2 samples");
    c.drive = {};
    c.drive.kind = DriveKind::sampled;
    expect_finding(c, "drive.file", "0 samples");
    c = sampled_case();
    c.drive.times = {0.0, 1.0, 1.0};
    expect_finding(c, "drive.file", "do not increase at sample 3");
    c.drive.times = {0.1, 0.5, 1.0};
    expect_finding(c, "drive.file", "starts at 0.1 s");
    c.drive.times = {0.0, 0.5, 0.9};
    expect_finding(c, "run.duration", "ends at 0.9 s");
}

TEST(Findings, CutsLeaveSomethingToJudge) {
    Case c;
    c.verdict.settling = 0.5;
    c.verdict.reversal = 0.5;
    expect_finding(c, "verdict.settling", "leaves nothing to judge");
    // a constant drive has no reversals, so the cuts mean nothing
    c.drive.kind = DriveKind::constant;
    EXPECT_TRUE(findings(c).empty());
}

TEST(Findings, AreAllNamedAtOnce) {
    Case c = constant_case();
    c.contact().kinetic_friction = 0.9;
    c.drive.velocity = 0.0;
    c.run.window = 2.0;
    EXPECT_EQ(findings(c).size(), 3U);
}

}  // namespace
}  // namespace stridor::parameters
