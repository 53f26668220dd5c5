// Runs with several contacts that end before their time, against the same runs that do not.

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/joints.hpp"
#include "support/many_contacts.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor {
namespace {

using integration::Motion;
using integration::Reason;
using parameters::Case;
using record::Future;

Case lips(double kinetic_friction, double first_angle, double second_angle) {
    Case c = parameters::two_lips();
    c.contact().kinetic_friction = kinetic_friction;
    c.joint().incidence_angle = first_angle;
    c.joints[1].contact.kinetic_friction = kinetic_friction;
    c.joints[1].joint.incidence_angle = second_angle;
    return c;
}

Motion run(Case c, parameters::EarlyEnding ending) {
    c.run.early_ending = ending;
    record::Request request;
    request.history = record::KeepHistory::yes;
    return integration::simulate(c, request);
}

// `part`: what of all sums a fraction of a period makes, which is filled by its mean
void expect_same_tallies(const Motion& early, const Motion& whole, double part) {
    const record::Tally& a = early.record.phases.front();
    const record::Tally& b = whole.record.phases.front();
    for (std::size_t k = 0; k < a.contacts.size(); ++k) {
        for (std::size_t state = 0; state < model::contact_states; ++state)
            EXPECT_NEAR(a.contacts[k].judged_time[state], b.contacts[k].judged_time[state], 1e-6) << k;
        EXPECT_NEAR(a.contacts[k].load.normal_impulse, b.contacts[k].load.normal_impulse,
                    part * b.contacts[k].load.normal_impulse);
        EXPECT_NEAR(a.contacts[k].load.friction_loss, b.contacts[k].load.friction_loss,
                    part * b.contacts[k].load.friction_loss);
        EXPECT_NEAR(static_cast<double>(a.contacts[k].releases), static_cast<double>(b.contacts[k].releases), 1.0);
    }
    for (std::size_t dof = 0; dof < a.vibration.size(); ++dof) {
        EXPECT_NEAR(a.vibration[dof].square_time, b.vibration[dof].square_time, part * b.vibration[dof].square_time);
        EXPECT_NEAR(a.vibration[dof].peak_square, b.vibration[dof].peak_square, 1e-3 * b.vibration[dof].peak_square);
    }
}

TEST(EarlyEnding, OfTwoLipsThatLockRepeatsTheirPeriod) {
    const Case c = lips(0.2, 70.0, 60.0);
    const Motion early = run(c, parameters::EarlyEnding::proven);
    ASSERT_EQ(early.outcome.reason, Reason::settled);
    ASSERT_TRUE(early.cycle.has_value());
    EXPECT_NEAR(early.cycle->period, 5.23846022e-3, 1e-11);
    EXPECT_EQ(early.record.phases.front().contacts.front().ending.outlook.future, Future::repeats);
    expect_same_tallies(early, run(c, parameters::EarlyEnding::never), 3e-3);
}

TEST(EarlyEnding, OfTwoLipsThatSlipForEverIsTheirVibrationDyingAway) {
    const Case c = lips(0.75, 70.0, 60.0);
    const Motion early = run(c, parameters::EarlyEnding::proven);
    ASSERT_EQ(early.outcome.reason, Reason::settled);
    ASSERT_TRUE(early.silence.has_value());
    for (const record::ContactTally& contact : early.record.phases.front().contacts)
        EXPECT_EQ(contact.ending.outlook.future, Future::slides);
    const Motion whole = run(c, parameters::EarlyEnding::never);
    expect_same_tallies(early, whole, 1e-6);
    for (const record::ContactHistory& history : whole.record.histories)
        EXPECT_LE(history.back().from, early.silence->time);
    // proven at the end, too
    EXPECT_EQ(whole.record.phases.front().contacts.front().ending.outlook.future, Future::slides);
}

RC_GTEST_PROP(EarlyEnding, AgreesWithTheWholeRunOfAnyTwoLips, ()) {
    Case c = lips(0.01 * *support::whole_between(5, 80), *support::number_between(20, 160),
                  *support::number_between(20, 160));
    c.contact().preload = *support::number_between(20, 400);
    c.plate.damping = c.joint().flexural_damping = 10.0;
    c.drive.velocity = *rc::gen::element(-0.3, -0.1, 0.1, 0.3);
    c.run.duration = 0.6;
    c.run.window = 0.3;
    const Motion early = run(c, parameters::EarlyEnding::proven);
    RC_CLASSIFY(early.silence.has_value(), "silence");
    RC_CLASSIFY(early.cycle.has_value(), "cycle");
    if (early.outcome.reason != Reason::settled) return;
    const Motion whole = run(c, parameters::EarlyEnding::never);
    RC_ASSERT(whole.outcome.reason == Reason::completed);
    for (std::size_t k = 0; k < 2; ++k) {
        if (early.silence) RC_ASSERT(whole.record.histories[k].back().from <= early.silence->time);
        for (std::size_t state = 0; state < model::contact_states; ++state)
            RC_ASSERT(std::abs(early.record.phases.front().contacts[k].judged_time[state] -
                               whole.record.phases.front().contacts[k].judged_time[state]) < 1e-6);
    }
}

}  // namespace
}  // namespace stridor
