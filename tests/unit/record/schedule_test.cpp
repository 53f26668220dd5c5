#include "stridor/record/schedule.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stridor::record {
namespace {

using parameters::Case;
using parameters::DriveKind;

double time_of(const Schedule& plan, Use use) {
    double sum = 0.0;
    for (const Span& span : plan.spans)
        if (span.use == use) sum += span.to - span.from;
    return sum;
}

Case constant_case() {
    Case c;
    c.drive.kind = DriveKind::constant;
    return c;
}

Case sampled_case(std::vector<double> times, std::vector<double> velocities) {
    Case c;
    c.drive.kind = DriveKind::sampled;
    c.drive.times = std::move(times);
    c.drive.velocities = std::move(velocities);
    c.run.duration = c.run.window = c.drive.times.back();
    return c;
}

TEST(ConstantDrive, IsJudgedOverItsWindow) {
    Case c = constant_case();
    c.run.duration = 2.0;
    c.run.window = 0.5;
    const Schedule plan = schedule(c);
    ASSERT_EQ(plan.spans.size(), 3U);
    EXPECT_EQ(plan.spans[0].use, Use::unused);
    EXPECT_EQ(plan.spans[1].use, Use::judged);
    EXPECT_EQ(plan.spans[1].from, 1.5);
    EXPECT_EQ(plan.spans[2].use, Use::closing);
    EXPECT_EQ(plan.spans[2].from, 2.0 - 0.2 * 0.5);
    EXPECT_EQ(plan.spans[2].to, 2.0);
    EXPECT_EQ(plan.phases, std::vector<Phase>{Phase::all});
}

// the start is no part of a verdict, though it lies in the window
TEST(ConstantDrive, IsJudgedOverTheSecondHalfAtMost) {
    Case c = constant_case();
    c.run.duration = c.run.window = 2.0;
    const Schedule plan = schedule(c);
    ASSERT_EQ(plan.spans.size(), 3U);
    EXPECT_EQ(plan.spans[0].use, Use::counted);
    EXPECT_EQ(plan.spans[1].from, 1.0);
    EXPECT_EQ(time_of(plan, Use::unused), 0.0);
    c.verdict.start = 0.0;
    EXPECT_EQ(schedule(c).spans.front().use, Use::judged);
    c.verdict.start = 0.9;
    EXPECT_DOUBLE_EQ(time_of(schedule(c), Use::counted), 1.8);
}

// V = cos(2 pi f t): going until T/4, coming until 3T/4, going until 5T/4 ...
TEST(SinusoidalDrive, TurnsAtQuarterPeriods) {
    Case c;
    c.drive.frequency = 1.0;
    c.run.duration = c.run.window = 2.0;
    for (const Span& span : schedule(c).spans) {
        const double middle = 0.5 * (span.from + span.to);
        const bool is_going = std::cos(2.0 * 3.141592653589793 * middle) > 0.0;
        EXPECT_EQ(span.phase, is_going ? Phase::going : Phase::coming) << span.from << " " << span.to;
    }
}

TEST(SinusoidalDrive, JudgesTheMiddleOfCompletePhases) {
    Case c;  // 5 Hz, 1 s: halves of 0.1 s; complete are five coming and four going
    const Schedule plan = schedule(c);
    EXPECT_EQ(plan.phases, (std::vector<Phase>{Phase::going, Phase::coming}));
    double going = 0.0, coming = 0.0;
    for (const Span& span : plan.spans) {
        if (span.use != Use::judged) continue;
        const double half_from = std::floor((span.from + 0.05) / 0.1) * 0.1 - 0.05;
        EXPECT_NEAR(span.from, half_from + 0.45 * 0.1, 1e-15);
        EXPECT_NEAR(span.to, half_from + 0.85 * 0.1, 1e-15);
        (span.phase == Phase::going ? going : coming) += span.to - span.from;
    }
    EXPECT_NEAR(going, 4 * 0.04, 1e-14);
    EXPECT_NEAR(coming, 5 * 0.04, 1e-14);
    EXPECT_EQ(time_of(plan, Use::unused), 0.0);
}

TEST(SinusoidalDrive, CountsCutPhasesWithoutJudgingThem) {
    Case c;
    c.run.duration = 1.0;
    c.run.window = 0.33;  // from 0.67: within the going phase 0.65 .. 0.75
    const Schedule plan = schedule(c);
    EXPECT_NEAR(time_of(plan, Use::unused), 0.67, 1e-14);
    EXPECT_NEAR(time_of(plan, Use::judged), 2 * 0.04, 1e-14);  // 0.75 .. 0.85 and 0.85 .. 0.95
    for (const Span& span : plan.spans)
        EXPECT_TRUE(span.use != Use::judged || span.from > 0.75);
}

// a window cut at a reversal is complete there, though 1 - 0.95 is not 0.05 in binary
TEST(SinusoidalDrive, IsNotFooledByRoundingAtTheWindowsEdge) {
    Case c;
    c.run.window = 0.95;
    EXPECT_NEAR(time_of(schedule(c), Use::judged), 9 * 0.04, 1e-13);
}

// going and coming take turns from the start on, half a period each, and all of them are complete
TEST(TrapezoidalDrive, TurnsAtHalfPeriods) {
    Case c;
    c.drive.kind = DriveKind::trapezoidal;  // 5 Hz, 1 s: ten halves of 0.1 s
    const Schedule plan = schedule(c);
    EXPECT_EQ(plan.phases, (std::vector<Phase>{Phase::going, Phase::coming}));
    for (const Span& span : plan.spans) {
        const double middle = 0.5 * (span.from + span.to);
        EXPECT_EQ(span.phase, std::fmod(middle, 0.2) < 0.1 ? Phase::going : Phase::coming) << middle;
    }
    EXPECT_NEAR(time_of(plan, Use::judged), 10 * 0.04, 1e-14);
    EXPECT_DOUBLE_EQ(end_of(plan), 1.0);
    c.drive.velocity = -0.1;
    EXPECT_EQ(schedule(c).spans.front().phase, Phase::coming);
}

TEST(SampledDrive, TurnsWhereTheVelocityCrossesZero) {
    const Schedule plan = schedule(sampled_case({0.0, 1.0, 3.0, 4.0}, {1.0, 1.0, -3.0, -3.0}));
    // V falls from 1 to -3 between 1 s and 3 s: zero at 1.5 s
    EXPECT_EQ(plan.phases, (std::vector<Phase>{Phase::going, Phase::coming}));
    for (const Span& span : plan.spans)
        EXPECT_EQ(span.phase, span.from < 1.5 ? Phase::going : Phase::coming);
    const auto turn = std::find_if(plan.spans.begin(), plan.spans.end(),
                                   [](const Span& span) { return span.phase == Phase::coming; });
    ASSERT_NE(turn, plan.spans.end());
    EXPECT_DOUBLE_EQ(turn->from, 1.5);
}

TEST(SampledDrive, StandingStillBelongsToThePhaseBefore) {
    const Schedule plan = schedule(sampled_case({0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, 0.0, 0.0, 0.0, 1.0}));
    EXPECT_EQ(plan.phases, std::vector<Phase>{Phase::going});
    EXPECT_DOUBLE_EQ(time_of(plan, Use::judged), 4.0 * (1.0 - 0.45 - 0.15));
}

// a case without `findings`, of any drive
Case any_case() {
    Case c;
    const int kind = *support::whole_between(0, 3);
    c.drive.kind = static_cast<DriveKind>(kind);
    c.drive.frequency = *support::number_between(1.0, 50.0);
    c.drive.ramp = 0.2 / c.drive.frequency;
    c.run.duration = *support::number_between(1.5, 4.0);
    c.run.window = *support::number_between(1.5, c.run.duration);
    c.verdict.settling = *support::number_between(0.0, 0.6);
    c.verdict.reversal = *support::number_between(0.0, 0.3);
    if (c.drive.kind != DriveKind::sampled) return c;
    const int samples = *support::whole_between(2, 20);
    for (int k = 0; k < samples; ++k) {
        c.drive.times.push_back(k * c.run.duration / (samples - 1));
        c.drive.velocities.push_back(*support::whole_between(-3, 3));
    }
    c.drive.velocities.front() = 1.0;  // it moves
    c.drive.times.back() = c.run.duration;
    return c;
}

bool tiles(const Schedule& plan, double duration) {
    double end = 0.0;
    for (const Span& span : plan.spans) {
        if (span.from != end || !(span.to > span.from)) return false;
        end = span.to;
    }
    return end == duration;
}

RC_GTEST_PROP(Schedule, SpansTileTheTimeAxis, ()) {
    const Case c = any_case();
    RC_ASSERT(tiles(schedule(c), c.run.duration));
}

TEST(Schedule, SpansTileTheTimeAxisWhereTheWindowBeginsWithinRoundingOfAReversal) {
    for (const double share : {0.0, 0.2})
        for (int k = 1; k < 14; ++k) {
            Case c;
            c.verdict.settling = c.verdict.reversal = share;
            c.run.window = 1.0 - 0.05 * k;
            EXPECT_TRUE(tiles(schedule(c), c.run.duration)) << share << " " << c.run.window;
            c.run.window = c.run.duration = 0.35 + 0.05 * k;
            EXPECT_TRUE(tiles(schedule(c), c.run.duration)) << share << " " << c.run.duration;
        }
}

RC_GTEST_PROP(Schedule, JudgesOnlyWithinTheWindow, ()) {
    const Case c = any_case();
    const double window_from = c.run.duration - c.run.window;
    for (const Span& span : schedule(c).spans)
        RC_ASSERT((span.use == Use::unused) == (span.to <= window_from));
}

RC_GTEST_PROP(Schedule, ListsEachPhaseThatOccurs, ()) {
    const Case c = any_case();
    const Schedule plan = schedule(c);
    for (const Span& span : plan.spans) {
        const bool is_listed = std::find(plan.phases.begin(), plan.phases.end(), span.phase) != plan.phases.end();
        RC_ASSERT(span.use == Use::unused || is_listed);
    }
    RC_ASSERT(std::is_sorted(plan.phases.begin(), plan.phases.end()));
}

}  // namespace
}  // namespace stridor::record
