// What is quiet is called so, with its reason; what is not is never called quiet.

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/seal_lip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace stridor {
namespace {

using classification::Category;
using classification::Quiet;
using classification::Verdict;
using parameters::Case;

std::vector<Verdict> verdicts(const Case& c) {
    return classification::classify_phases(integration::simulate(c).record.phases, c.verdict);
}

Verdict verdict(const Case& c) {
    return verdicts(c).front();
}

// 9.7 N/mm more and more: it makes no noise, and is no quiet design
TEST(LockingLip, LocksHoweverItStartsAndHoweverLongItIsLookedAt) {
    for (const parameters::Initial start : {parameters::Initial::rest, parameters::Initial::stuck})
        for (const double window : {1.0, 0.999, 0.5, 0.1})
            for (const parameters::Engine engine :
                 {parameters::Engine::exact, parameters::Engine::beta_2, parameters::Engine::moreau}) {
                Case c = support::seal_lip();
                c.run.initial = start;
                c.run.window = window;
                c.run.engine = engine;
                c.run.step = 1e-5;
                const Verdict result = verdict(c);
                EXPECT_EQ(result.category, Category::none) << window;
                EXPECT_EQ(result.quiet, Quiet::locks) << window;
                EXPECT_NE(result.reasons.back().find(" to 494 N over 50 mm and goes on by 9.71 N/mm (proven)"),
                          std::string::npos)
                    << result.reasons.back();
            }
}

TEST(LockingLip, LocksAtAnyThreshold) {
    Case c = support::seal_lip();
    c.verdict.start = 0.0;
    EXPECT_EQ(verdict(c).quiet, Quiet::locks);
}

// 12 Hz: it slips in the first stroke and never again
TEST(QuietLip, UnderASinusoidalDriveDoesNotCreakForItsFirstStroke) {
    Case c = support::seal_lip();
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.amplitude = 0.5e-3;
    c.drive.frequency = 12.0;
    for (const double preload : {0.5, 1.0, 2.0, 5.0}) {
        c.contact().preload = preload;
        for (const Verdict& result : verdicts(c)) {
            EXPECT_EQ(result.category, Category::none) << preload;
            // the swing of 5 N and what the first slip has left is ten times a small preload
            EXPECT_EQ(result.quiet, preload > 1.0 ? Quiet::sticks : Quiet::locks) << preload;
        }
    }
}

TEST(NoisyLip, SquealsComingWhereItDoesNotLock) {
    Case c = support::seal_lip();
    c.drive.velocity = -0.05;
    EXPECT_EQ(verdict(c).category, Category::squeal);
}

// a creak of 1.1 s looked at for half a second is stuck throughout: that is no silence
TEST(SlowCreak, IsUndecidedWhileTheRunIsTooShortAndCreakOnceItIsNot) {
    Case c = support::seal_lip();
    c.joint().incidence_angle = 90.0;
    c.contact().kinetic_friction = 0.4;
    c.drive.velocity = 5e-3;
    c.run.initial = parameters::Initial::stuck;
    const Verdict early = verdict(c);
    EXPECT_EQ(early.evidence.judged_rates.stick, 1.0);
    EXPECT_EQ(early.category, Category::undecided);
    c.run.duration = 20.0;
    c.run.window = 15.0;
    EXPECT_EQ(verdict(c).category, Category::creak);
}

// three lips on one plate: the one that leans into the motion locks, and pushes the plate away from the others
TEST(LockingLip, PushesThePlateAwayFromItsNeighbours) {
    Case c = support::seal_lip();
    c.joints[0].name = "lip1";
    for (const double angle : {120.0, 110.0}) {
        parameters::PlateJoint further = c.joints.front();
        further.name = "lip" + std::to_string(c.joints.size() + 1);
        further.joint.incidence_angle = angle;
        c.joints.push_back(further);
    }
    c.run.duration = c.run.window = 3.0;
    const Verdict result = verdict(c);
    EXPECT_EQ(result.category, Category::none);
    EXPECT_EQ(result.quiet, Quiet::locks);
    EXPECT_EQ(result.evidence.contact, 0U);
    EXPECT_EQ(result.reasons.back(), "2 contacts have lifted off and stay off");
}

TEST(QuietLevel, IsThatOfTheEndWhateverTheWindow) {
    Case c = parameters::paper_case(parameters::PaperCase::quiet);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = -0.1;
    const Verdict whole = verdict(c);
    c.run.window = 0.5;
    const Verdict half = verdict(c);
    ASSERT_EQ(whole.category, Category::none);
    ASSERT_EQ(whole.quiet, Quiet::slides);
    EXPECT_EQ(whole.evidence.levels.plate.rms, half.evidence.levels.plate.rms);
    EXPECT_EQ(whole.evidence.levels.joint.rms, half.evidence.levels.joint.rms);
    EXPECT_LT(whole.evidence.judged_time, whole.evidence.window_time);
}

}  // namespace
}  // namespace stridor
